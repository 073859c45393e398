// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "base/planar.h"
#include "surface/mesh/geometry.h"
#include "test_meshes.h"
#include "warp/topology/embed_path.h"
#include "warp/topology/straightest_geodesic.h"

namespace wirewarp::test_embed_path {
namespace {

/// A flat 8 by 8 square of side 8 with a rigid wire along column 6.
struct Plate {
  Plate() {
    FlattenInput input = test::flat_rectangle(8, 8, 8, 8);
    test::add_wire(input, test::grid_column(8, 8, 6));
    chart = test::charts_of(input).charts[0];
  }
  VertexHandle vertex(int i, int j) const { return VertexHandle(i + 9 * j); }
  MeshPath trace(int i, int j, double angle) const {
    const HalfedgeHandle reference = chart.mesh.find_halfedge(vertex(i, j), vertex(i + 1, j));
    return *trace_straightest(chart.mesh, WireMask(chart), reference, angle);
  }
  Chart chart;
};

double area(const HalfEdgeMesh& mesh) {
  double sum = 0;
  for (const FaceHandle f : mesh.faces()) {
    const HalfedgeHandle h = mesh.halfedge_handle(f);
    const auto a = mesh.point(mesh.from_vertex_handle(h));
    const auto b = mesh.point(mesh.to_vertex_handle(h));
    const auto c = mesh.point(mesh.to_vertex_handle(mesh.next_halfedge_handle(h)));
    EXPECT_GT(((b - a) % (c - a))[2], 0) << "a turned triangle";
    sum += ((b - a) % (c - a))[2] / 2;
  }
  return sum;
}

TEST(EmbedPath, EachCrossingAddsAVertexAndTwoTriangles) {
  const Plate plate;
  const WireMask wires(plate.chart);
  const auto path = snap_to_wires(plate.chart.mesh, wires, plate.trace(2, 4, 0.4));
  ASSERT_TRUE(path);
  std::size_t num_crossings = 0;
  for (const PathPoint& point : *path) num_crossings += point.is_vertex() ? 0 : 1;
  ASSERT_GT(num_crossings, 3u);

  SplitChart refined(plate.chart);
  const HalfEdgeChain chain = embed_path(refined, *path);
  const HalfEdgeMesh& mesh = refined.chart.mesh;
  EXPECT_EQ(mesh.n_vertices(), plate.chart.mesh.n_vertices() + num_crossings);
  EXPECT_EQ(mesh.n_faces(), plate.chart.mesh.n_faces() + 2 * num_crossings);
  EXPECT_EQ(refined.chart.source_face.size(), mesh.n_faces());
  EXPECT_EQ(refined.chart.source_vertex.back(), -1);
  EXPECT_NEAR(area(mesh), 64, 1e-12);
  ASSERT_EQ(chain.size(), path->size() - 1);
  for (std::size_t i = 0; i < chain.size(); ++i) {
    ASSERT_TRUE(chain[i].is_valid());
    EXPECT_LT((mesh.point(mesh.from_vertex_handle(chain[i])) - position(plate.chart.mesh, (*path)[i])).norm(), 1e-14);
  }
}

TEST(EmbedPath, APathAtAWireEndsAtTheNearerEndOfTheEdge) {
  const Plate plate;
  const auto path = snap_to_wires(plate.chart.mesh, WireMask(plate.chart), plate.trace(2, 4, 0.2));
  ASSERT_TRUE(path);
  EXPECT_EQ(path->back().vertex, plate.vertex(6, 5)) << "4 + 4 tan 0.2 = 4.81";
}

TEST(EmbedPath, APathNearAVertexRunsThroughIt) {
  const Plate plate;
  const auto path = snap_to_wires(plate.chart.mesh, WireMask(plate.chart), plate.trace(1, 4, 0.005));
  ASSERT_TRUE(path);
  ASSERT_EQ(path->size(), 6u);
  for (int i = 0; i < 6; ++i) EXPECT_EQ((*path)[i].vertex, plate.vertex(1 + i, 4)) << "no crossing is left";
}

TEST(EmbedPath, APathThatIsAWireAlreadyGoesNowhere) {
  const Plate plate;
  const MeshPath path{PathPoint::at_vertex(plate.vertex(6, 3)), PathPoint::at_vertex(plate.vertex(6, 4))};
  EXPECT_FALSE(snap_to_wires(plate.chart.mesh, WireMask(plate.chart), path));
}

TEST(EmbedPath, LaterPathsSeeEarlierOnesAsWires) {
  const Plate plate;
  SplitChart refined(plate.chart);
  const auto first = snap_to_wires(plate.chart.mesh, refined.wires, plate.trace(2, 4, 0.4));
  add_helper_wire(refined, embed_path(refined, *first));

  const HalfEdgeMesh& mesh = refined.chart.mesh;
  const HalfedgeHandle up = mesh.find_halfedge(plate.vertex(4, 2), plate.vertex(4, 3));
  const auto second = trace_straightest(mesh, refined.wires, up, 0.05);
  ASSERT_TRUE(second);
  EXPECT_LT(position(mesh, second->back())[1], 6) << "ends on the first path, not at the boundary";
  const auto snapped = snap_to_wires(mesh, refined.wires, *second);
  ASSERT_TRUE(snapped);
  const HalfEdgeChain chain = embed_path(refined, *snapped);
  EXPECT_TRUE(refined.wires.has(mesh.to_vertex_handle(chain.back())));
  EXPECT_NEAR(area(mesh), 64, 1e-12);
}

TEST(EmbedPath, DelaunayFlipsStayInsideOneInputFace) {
  const Plate plate;
  SplitChart refined(plate.chart);
  const auto path = snap_to_wires(plate.chart.mesh, refined.wires, plate.trace(2, 4, 0.4));
  add_helper_wire(refined, embed_path(refined, *path));
  WorkMeter work{StopToken()};
  restore_delaunay(refined, work);
  const HalfEdgeMesh& mesh = refined.chart.mesh;
  EXPECT_NEAR(area(mesh), 64, 1e-12);
  std::vector<double> face_area(plate.chart.mesh.n_faces(), 0);
  for (const FaceHandle f : mesh.faces()) {
    const HalfedgeHandle h = mesh.halfedge_handle(f);
    const auto a = mesh.point(mesh.from_vertex_handle(h));
    const auto b = mesh.point(mesh.to_vertex_handle(h));
    const auto c = mesh.point(mesh.to_vertex_handle(mesh.next_halfedge_handle(h)));
    face_area[refined.chart.source_face[f.idx()]] += ((b - a) % (c - a))[2] / 2;
  }
  for (const double a : face_area) EXPECT_NEAR(a, 0.5, 1e-14);
}

TEST(EmbedPath, InsideAnInputFaceTheTrianglesAreDelaunay) {
  const Plate plate;
  for (const double angle : {0.4, 1.2, 2.5, 4.0, 5.5}) {
    const auto path = snap_to_wires(plate.chart.mesh, WireMask(plate.chart), plate.trace(3, 4, angle));
    SplitChart one(plate.chart);
    add_helper_wire(one, embed_path(one, *path));
    WorkMeter work{StopToken()};
    restore_delaunay(one, work);
    for (const EdgeHandle e : one.chart.mesh.edges()) {
      const HalfedgeHandle h = one.chart.mesh.halfedge_handle(e, 0);
      const HalfedgeHandle o = one.chart.mesh.opposite_halfedge_handle(h);
      if (one.wires.has(e)) continue;
      const FaceHandle f = one.chart.mesh.face_handle(h);
      const FaceHandle g = one.chart.mesh.face_handle(o);
      if (one.chart.source_face[f.idx()] != one.chart.source_face[g.idx()]) continue;
      const double opposite_angles = corner_angle(one.chart.mesh, one.chart.mesh.prev_halfedge_handle(h)) +
                                     corner_angle(one.chart.mesh, one.chart.mesh.prev_halfedge_handle(o));
      EXPECT_LT(opposite_angles, kPi + 1e-6);
    }
  }
}

}  // namespace
}  // namespace wirewarp::test_embed_path
