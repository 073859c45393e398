// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "base/planar.h"
#include "surface/mesh/geometry.h"
#include "test_meshes.h"
#include "warp/topology/embed_path.h"
#include "warp/topology/shortest_path.h"
#include "warp/topology/straightest_geodesic.h"

namespace wirewarp::test_mesh_paths {
namespace {

/// Returns the position of a grid vertex in the unrolled plane.
using Unroll = std::function<Planar(int column, int row)>;

struct UnrolledTrace {
  double length = 0;  // distance between the ends, in the unrolled plane
  double largest_miss = 0;
  std::size_t num_points = 0;
};

UnrolledTrace trace_unrolled(const FlattenInput& input, int nx, int column, int row, double heading,
                             const Unroll& unroll) {
  const Chart chart = test::chart_of(input);
  const HalfEdgeMesh& mesh = chart.mesh;
  const WireMask wires(chart);
  const auto plane = [&](VertexHandle v) { return unroll(v.idx() % (nx + 1), v.idx() / (nx + 1)); };
  const VertexHandle start(column + (nx + 1) * row);
  const HalfedgeHandle reference = mesh.find_halfedge(start, VertexHandle(start.idx() + 1));
  const Planar direction = std::polar(1.0, heading);
  double angle = std::arg(direction / (plane(VertexHandle(start.idx() + 1)) - plane(start)));
  if (angle < 0) angle += 2 * kPi;
  const auto path = trace_straightest(mesh, wires, reference, angle);
  UnrolledTrace result;
  if (!path) return result;
  result.num_points = path->size();
  for (const PathPoint& point : *path) {
    Planar p;
    if (point.is_vertex()) {
      p = plane(point.vertex);
    } else {
      const Planar from = plane(mesh.from_vertex_handle(point.half_edge));
      p = from + point.t * (plane(mesh.to_vertex_handle(point.half_edge)) - from);
    }
    result.largest_miss = std::max(result.largest_miss, std::abs(cross(direction, p - plane(start))));
    result.length = std::real(std::conj(direction) * (p - plane(start)));
  }
  return result;
}

TEST(StraightestGeodesic, IsAStraightLineOnThePlane) {
  const int n = 20;
  const FlattenInput input = test::flat_rectangle(n, n, 1, 1);
  const auto identity = [&](int i, int j) { return Planar(double(i) / n, double(j) / n); };
  for (double heading = 0.1; heading < 2 * kPi; heading += 0.37) {
    const UnrolledTrace trace = trace_unrolled(input, n, 10, 10, heading, identity);
    EXPECT_GT(trace.num_points, 10u) << heading;
    EXPECT_LT(trace.largest_miss, 1e-13) << heading;
    // The path leads from the center to the rim of the unit square.
    EXPECT_NEAR(trace.length, 0.5 / std::max(std::abs(std::cos(heading)), std::abs(std::sin(heading))), 1e-12);
  }
}

TEST(StraightestGeodesic, RunsThroughVerticesAndAlongEdges) {
  const int n = 8;
  const FlattenInput input = test::flat_rectangle(n, n, 1, 1);
  const auto identity = [&](int i, int j) { return Planar(double(i) / n, double(j) / n); };
  for (int k = 0; k < 8; ++k) {
    const UnrolledTrace trace = trace_unrolled(input, n, 4, 4, k * kPi / 4, identity);
    EXPECT_LT(trace.largest_miss, 1e-13) << k;
    EXPECT_NEAR(trace.length, k % 2 == 0 ? 0.5 : std::sqrt(0.5), 1e-12);
    // At k = 3 and 7, the trace also crosses the diagonal of each quad.
    EXPECT_EQ(trace.num_points, k == 3 || k == 7 ? 9u : 5u) << k;
  }
}

TEST(StraightestGeodesic, UnrollsToALineOnCylindersAndCones) {
  const int n = 60;
  const double angle = 4, half_angle = 0.6, near = 0.5, far = 3;
  const double chord = 2 * 2 * std::sin(angle / n / 2);                                 // the mesh is a prism
  const double sector = 2 * std::asin(std::sin(half_angle) * std::sin(angle / n / 2));  // the mesh is a pyramid
  const std::pair<FlattenInput, Unroll> surfaces[] = {
      {test::cylinder_patch(n, n, 2, angle, 7), [=](int i, int j) { return Planar(chord * i, 7.0 * j / n); }},
      {test::cone_patch(n, n, near, far, half_angle, angle),
       [=](int i, int j) { return std::polar(far + (near - far) * j / n, sector * i - kPi / 2); }}};
  for (const auto& [input, unroll] : surfaces) {
    for (double heading = 0.05; heading < 2 * kPi; heading += 0.51) {
      const UnrolledTrace trace = trace_unrolled(input, n, 25, 31, heading, unroll);
      EXPECT_GT(trace.num_points, 20u) << heading;
      EXPECT_LT(trace.largest_miss, 1e-10) << heading;
    }
  }
}

double miss_of_great_circle(int n) {
  Chart chart = test::chart_of(test::quarter_sphere(n));
  chart.wire_parts.clear();
  const HalfEdgeMesh& mesh = chart.mesh;
  const VertexHandle start(n / 2 + (n + 1) * n);  // where the meridian crosses the equator
  const HalfedgeHandle reference = mesh.find_halfedge(start, VertexHandle(start.idx() + 1));
  const double heading = 0.6;
  const auto path = trace_straightest(mesh, WireMask(chart), reference, heading);
  if (!path) return 1;
  const HalfEdgeMesh::Point east(-std::sqrt(0.5), std::sqrt(0.5), 0);
  const HalfEdgeMesh::Point direction = east * std::cos(heading) + HalfEdgeMesh::Point(0, 0, std::sin(heading));
  const HalfEdgeMesh::Point normal = mesh.point(start) % direction;
  double largest = 0;
  for (const PathPoint& point : *path) largest = std::max(largest, std::abs(position(mesh, point) | normal));
  return largest;
}

TEST(StraightestGeodesic, TendsToAGreatCircleOnTheSphere) {
  EXPECT_LT(miss_of_great_circle(16), 0.02);
  EXPECT_LT(miss_of_great_circle(64), 0.005);
}

/// Returns a pyramid of two rings with n vertices each, and an apex, which is the last vertex.
FlattenInput pyramid(int n) {
  FlattenInput input = test::make_tube(n, 1, [&](double s, double t) {
    return Eigen::Vector3d((2 - t) * std::cos(2 * kPi * s), (2 - t) * std::sin(2 * kPi * s), t);
  });
  input.vertices.conservativeResize(2 * n + 1, 3);
  input.vertices.row(2 * n) << 0, 0, 2;
  input.faces.conservativeResize(3 * n, 3);
  for (int i = 0; i < n; ++i) input.faces.row(2 * n + i) << n + i, n + (i + 1) % n, 2 * n;
  return input;
}

TEST(StraightestGeodesic, LeavesAnApexWithEqualAnglesLeftAndRight) {
  for (const int n : {5, 6}) {
    const Chart chart = test::chart_of(pyramid(n));
    const HalfEdgeMesh& mesh = chart.mesh;
    const HalfedgeHandle to_apex = mesh.find_halfedge(VertexHandle(n), VertexHandle(2 * n));
    const auto path = trace_straightest(mesh, WireMask(chart), to_apex, 0);
    ASSERT_TRUE(path);
    ASSERT_EQ(path->size(), n % 2 == 0 ? 4u : 5u) << "along an edge, or through the middle of a side";
    EXPECT_EQ((*path)[1].vertex, VertexHandle(2 * n));
    const auto beyond = position(mesh, (*path)[2]);
    EXPECT_LT(beyond[0], 0);
    EXPECT_NEAR(beyond[1], 0, 1e-14) << "in the mirror plane of the pyramid";
  }
}

TEST(StraightestGeodesic, EndsWithoutAPathIfItReturnsToItsStart) {
  const int nx = 12;
  const Chart chart = test::chart_of(test::cylinder_tube(nx, 8, 1, 2));
  const HalfEdgeMesh& mesh = chart.mesh;
  const VertexHandle start(nx * 4);
  const HalfedgeHandle around = mesh.find_halfedge(start, VertexHandle(nx * 4 + 1));
  const WireMask wires(chart);
  EXPECT_FALSE(trace_straightest(mesh, wires, around, 0)) << "a ring of edges";
  EXPECT_FALSE(trace_straightest(mesh, wires, around, 1e-4)) << "a flat spiral";
  EXPECT_TRUE(trace_straightest(mesh, wires, around, 1)) << "a steep spiral";
}

double geodesic_length(const Chart& chart, int from, int to) {
  const WireMask wires(chart);
  std::vector<char> is_target(chart.mesh.n_vertices(), 0);
  is_target[to] = 1;
  const auto edge_path = shortest_edge_path(chart.mesh, wires, {VertexHandle(from)}, is_target);
  EXPECT_FALSE(edge_path.empty());
  const MeshPath path = straighten(chart.mesh, wires, edge_path);
  EXPECT_EQ(path.front().vertex, VertexHandle(from));
  EXPECT_EQ(path.back().vertex, VertexHandle(to));
  return path_length(chart.mesh, path);
}

TEST(ShortestPath, IsTheLineBetweenTwoVerticesOfAPlane) {
  const int n = 20;
  const Chart chart = test::chart_of(test::flat_rectangle(n, n, n, n));
  const auto vertex = [&](int i, int j) { return i + (n + 1) * j; };
  for (const auto& [i, j] : {std::pair{17, 3}, {3, 17}, {10, 18}, {18, 9}, {2, 3}, {18, 18}}) {
    EXPECT_NEAR(geodesic_length(chart, vertex(2, 2), vertex(i, j)), std::hypot(i - 2, j - 2), 1e-12);
  }
}

TEST(ShortestPath, IsExactOnACone) {
  const int n = 40;
  const double angle = 2;
  const Chart chart = test::chart_of(test::cone_patch(n, n, 1, 4, 0.5, angle));
  const double sector = 2 * std::asin(std::sin(0.5) * std::sin(angle / n / 2));  // the mesh is a pyramid
  const auto unrolled = [&](int i, int j) { return std::polar(4 - 3.0 * j / n, sector * i); };
  const auto vertex = [&](int i, int j) { return i + (n + 1) * j; };
  for (const auto& [i, j] : {std::pair{35, 5}, {5, 37}, {30, 30}, {12, 36}}) {
    const double exact = std::abs(unrolled(i, j) - unrolled(3, 6));
    EXPECT_NEAR(geodesic_length(chart, vertex(3, 6), vertex(i, j)), exact, 1e-10);
  }
}

TEST(ShortestPath, StaysAQuarterOfAnEdgeAwayFromWires) {
  // The slit is between the two vertices, so the path leads around the slit's end.
  const int n = 8;
  FlattenInput input = test::flat_rectangle(n, n, n, n);
  test::add_seam(input, test::section(test::grid_column(n, n, 4), 0, 5));
  const Chart chart = test::chart_of(input);
  const auto find = [&](int i, int j) { return test::position_in(chart.source_vertex, i + (n + 1) * j); };
  const double length = geodesic_length(chart, find(1, 2), find(7, 2));
  EXPECT_GT(length, 2 * std::hypot(3, 3)) << "longer than touching the slit's end";
  EXPECT_LT(length, 2 * std::hypot(3, 3.5)) << "not as long as through the next vertices";
}

TEST(ShortestPath, TakesTheNearestOfManySourcesAndTargets) {
  const int n = 10;
  const Chart chart = test::chart_of(test::flat_rectangle(n, n, 1, 1));
  const auto vertex = [&](int i, int j) { return VertexHandle(i + (n + 1) * j); };
  std::vector<char> is_target(chart.mesh.n_vertices(), 0);
  is_target[vertex(2, 8).idx()] = 1;
  is_target[vertex(8, 5).idx()] = 1;
  const auto path =
      shortest_edge_path(chart.mesh, WireMask(chart), {vertex(1, 1), vertex(6, 5), vertex(3, 3)}, is_target);
  EXPECT_EQ(path, (std::vector<VertexHandle>{vertex(6, 5), vertex(7, 5), vertex(8, 5)}));
}

TEST(ShortestPath, ThrowsIfThereIsNoPath) {
  const Chart chart = test::chart_of(test::flat_rectangle(4, 4, 1, 1));
  SplitChart split(chart);
  const std::vector<char> no_target(chart.mesh.n_vertices(), 0);
  EXPECT_THROW(join_by_shortest_path(split, {VertexHandle(12)}, no_target), std::domain_error);
}

/// A flat square of side 8 with 8 by 8 quads and a rigid wire along column 6.
struct Plate {
  Plate() {
    FlattenInput input = test::flat_rectangle(8, 8, 8, 8);
    test::add_wire(input, test::grid_column(8, 8, 6));
    chart = test::chart_of(input);
  }
  VertexHandle vertex(int i, int j) const { return VertexHandle(i + 9 * j); }
  MeshPath trace(int i, int j, double angle) const {
    const HalfedgeHandle reference = chart.mesh.find_halfedge(vertex(i, j), vertex(i + 1, j));
    return *trace_straightest(chart.mesh, WireMask(chart), reference, angle);
  }
  Chart chart;
};

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
  for (int i = 0; i < 6; ++i) EXPECT_EQ((*path)[i].vertex, plate.vertex(1 + i, 4)) << "every crossing snaps";
}

TEST(EmbedPath, APathAlongAWireIsRejected) {
  const Plate plate;
  const MeshPath path{PathPoint::at_vertex(plate.vertex(6, 3)), PathPoint::at_vertex(plate.vertex(6, 4))};
  EXPECT_FALSE(snap_to_wires(plate.chart.mesh, WireMask(plate.chart), path));
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
      const HalfEdgeMesh& mesh = one.chart.mesh;
      const HalfedgeHandle h = mesh.halfedge_handle(e, 0), o = mesh.opposite_halfedge_handle(h);
      if (one.wires.has(e)) continue;
      const auto source = [&](HalfedgeHandle side) { return one.chart.source_face[mesh.face_handle(side).idx()]; };
      if (source(h) != source(o)) continue;
      EXPECT_LT(corner_angle(mesh, mesh.prev_halfedge_handle(h)) + corner_angle(mesh, mesh.prev_halfedge_handle(o)),
                kPi + 1e-6);
    }
  }
}

}  // namespace
}  // namespace wirewarp::test_mesh_paths
