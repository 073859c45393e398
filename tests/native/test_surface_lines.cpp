// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of lines on surfaces: of their mirror images, of their relaxation, and of the straight walk of their points.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>
#include <vector>

#include "base/planar.h"
#include "cuts/feasibility/cut_mask.h"
#include "cuts/propose/cut_again.h"
#include "cuts/propose/flat_pieces.h"
#include "cuts/propose/mirror_image.h"
#include "cuts/propose/relax_lines.h"
#include "cuts/propose/surface_lines.h"
#include "cuts/propose/symmetric_paths.h"
#include "judge_cuts.h"
#include "surface/mesh/geometry.h"
#include "test_meshes.h"
#include "warp/topology/straight_walk.h"
#include "wirewarp/cut_mesh.h"

namespace wirewarp::test_surface_lines {
namespace {

constexpr int kCells = 8;

/// Returns a sheet of 8 by 8 cells, with x from 0 to 8. All diagonals have mirror images across the plane x = 4, and no
/// other plane mirrors the sheet.
FlattenInput mirrored_sheet() {
  FlattenInput sheet = test::make_grid(
      kCells, kCells, [](double s, double t) { return Eigen::Vector3d(kCells * s, kCells * t, 2 * t * t * t); });
  int f = 0;
  for (int y = 0; y < kCells; ++y) {
    for (int x = 0; x < kCells; ++x) {
      const int a = y * (kCells + 1) + x, b = a + 1, c = a + kCells + 1, d = c + 1;
      if (x < kCells / 2) {
        sheet.faces.row(f++) << a, b, d;
        sheet.faces.row(f++) << a, d, c;
      } else {
        sheet.faces.row(f++) << a, b, c;
        sheet.faces.row(f++) << b, d, c;
      }
    }
  }
  return sheet;
}

/// Returns the path through these places (x, y) of the sheet. Consecutive places must be in one face.
SurfacePath path_through(const FlattenInput& sheet, const std::vector<std::pair<double, double>>& places) {
  SurfacePath path{{}, Positions3(places.size(), 3)};
  for (const auto& [x, y] : places) {
    for (int f = 0; f < static_cast<int>(sheet.faces.rows()); ++f) {
      Eigen::Matrix3d corners;
      for (int k = 0; k < 3; ++k) corners.col(k) = sheet.vertices.row(sheet.faces(f, k)).transpose();
      corners.row(2).setOnes();
      const Eigen::Vector3d weights = corners.inverse() * Eigen::Vector3d(x, y, 1);
      if (weights.minCoeff() < -1e-12) continue;
      path.coordinates.row(path.faces.size()) = weights.cwiseMax(0.0);
      path.faces.push_back(f);
      break;
    }
  }
  return path;
}

TEST(SurfaceLines, OfACutMeshCutTheInputAtTheSamePlaces) {
  const FlattenInput sheet = mirrored_sheet();
  // One line leads from the outline across edges and faces to a junction inside a face. Two other lines begin at the
  // junction.
  const std::vector<SurfacePath> paths{
      path_through(sheet, {{0, 2}, {0.6, 2.6}, {1, 2.75}, {1.5625, 2.5625}, {1.75, 2.5}}),
      path_through(sheet, {{1.75, 2.5}, {2, 2.6}, {2.7, 2.7}, {3, 3}, {4, 3}}),
      path_through(sheet, {{1.75, 2.5}, {1.9, 2}, {1.8, 1.8}, {1.5, 1}}),
  };
  const CutMesh cut = cut_mesh(sheet.vertices, sheet.faces, paths);
  const Chart chart = test::chart_of(sheet);
  const Chart cut_chart = test::chart_of({cut.vertices, cut.faces, {}, {}, {}});
  const SurfaceLines lines = lines_across(sheet, chart, cut, cut_chart, {}, PartMap(cut_chart).mask_of(cut.edges));
  ASSERT_EQ(lines.lines.size(), 3U);
  const CutMesh second = cut_mesh(sheet.vertices, sheet.faces, paths_of(sheet, chart, lines));
  ASSERT_EQ(second.vertices.rows(), cut.vertices.rows());
  EXPECT_EQ(second.edges.size(), cut.edges.size());
  for (const auto& vertex : cut.vertices.rowwise()) {
    EXPECT_LT((second.vertices.rowwise() - vertex).rowwise().norm().minCoeff(), 1e-9);
  }
}

TEST(SurfaceLines, MeetAtTheEndsOfALineThatIsLeftOut) {
  SurfaceLines all{{{1, 2, {}}, {2, 3, {}}, {3, 4, {}}, {5, 3, {}}, {4, 1, {}}}, {0, 2, 1, 4, 3}, true};
  const SurfaceLines kept = selected(all, {1, 0, 1, 1, 1});
  ASSERT_EQ(kept.lines.size(), 4U);
  EXPECT_EQ(kept.lines[0].last, kept.lines[1].first);
  EXPECT_EQ(kept.lines[0].last, kept.lines[2].last);
  EXPECT_NE(kept.lines[0].first, kept.lines[0].last);
  EXPECT_EQ(kept.images, (std::vector<std::size_t>{0, 1, 3, 2}));  // kept.lines[1] has lost its image
  EXPECT_FALSE(kept.is_symmetric);
  all.images = {0, 1, 2, 4, 3};
  EXPECT_TRUE(selected(all, {1, 0, 1, 1, 1}).is_symmetric);
}

TEST(SurfaceLines, CollapseIfCutMeshWouldMoveThemToOneVertex) {
  const FlattenInput sheet = mirrored_sheet();
  const std::vector<SurfacePath> paths{
      path_through(sheet, {{2, 2}, {2.01, 2.01}}),
      path_through(sheet, {{2.01, 2.01}, {2.6, 2.4}, {3, 3}}),
  };
  const std::vector<char> kept = not_collapsed(sheet.faces, static_cast<int>(sheet.vertices.rows()), paths);
  EXPECT_EQ(kept, (std::vector<char>{0, 1}));
  EXPECT_THROW(cut_mesh(sheet.vertices, sheet.faces, paths), FlattenError);
  EXPECT_NO_THROW(cut_mesh(sheet.vertices, sheet.faces, selected(paths, kept)));
}

TEST(PathMirror, MakesPairsExactAndPutsOtherPathsOnThePlane) {
  const FlattenInput sheet = mirrored_sheet();
  const Chart chart = test::chart_of(sheet);
  const std::vector<VertexHandle> image = mirror_image(chart, StopToken());
  ASSERT_FALSE(image.empty());
  const double off = 0.01;  // less than a tenth of an edge
  std::vector<SurfacePath> paths{
      path_through(sheet, {{1, 2.5}, {2, 3.3}, {3, 3.6}}),
      path_through(sheet, {{7, 2.5 + off}, {6, 3.3}, {5, 3.6 - off}}),
      path_through(sheet, {{4, 5}, {4 + off, 5.5}, {4, 6}}),            // along the plane
      path_through(sheet, {{3, 6.5}, {4, 6.8}, {5, 6.5 + off}}),        // across the plane
      path_through(sheet, {{4 + off, 1.5}, {5, 1.3}, {6, 1.2}}),        // from the plane
      path_through(sheet, {{4 - off, 1.5}, {3, 1.3 + off}, {2, 1.2}}),  // the mirror image of paths[4]
  };
  PathMirror(sheet, chart, image).make_symmetric({1, 0, 2, 3, 5, 4}, paths);
  const auto expect_images = [&](const SurfacePath& a, const SurfacePath& b, bool is_reversed) {
    ASSERT_EQ(a.faces.size(), b.faces.size());
    for (std::size_t i = 0; i < a.faces.size(); ++i) {
      const Eigen::RowVector3d p = test::point_of(sheet, a, i);
      const Eigen::RowVector3d q = test::point_of(sheet, b, is_reversed ? a.faces.size() - 1 - i : i);
      EXPECT_LT((q - Eigen::RowVector3d(kCells - p[0], p[1], p[2])).norm(), 1e-12);
    }
  };
  expect_images(paths[0], paths[1], false);
  expect_images(paths[2], paths[2], false);
  expect_images(paths[3], paths[3], true);
  expect_images(paths[4], paths[5], false);
  EXPECT_NEAR(test::point_of(sheet, paths[4], 0)[0], kCells / 2.0, 1e-12);
}

TEST(LineNetwork, DoesNotFollowBarriers) {
  const int n = 12;
  const Chart chart = test::chart_of(test::flat_rectangle(n, n, n, n));
  const auto at = [](int x, int y) { return VertexHandle(y * (n + 1) + x); };
  std::vector<VertexHandle> arch;  // a line over the barrier
  for (int x = 0; x < 3; ++x) arch.push_back(at(x, 6));
  for (int y = 6; y < 9; ++y) arch.push_back(at(3, y));
  for (int x = 3; x < 9; ++x) arch.push_back(at(x, 9));
  for (int y = 9; y > 6; --y) arch.push_back(at(9, y));
  for (int x = 9; x <= n; ++x) arch.push_back(at(x, 6));
  HalfEdgeChain chain;
  for (std::size_t i = 1; i < arch.size(); ++i) chain.push_back(chart.mesh.find_halfedge(arch[i - 1], arch[i]));
  CutMask barriers(chart.mesh.n_edges(), 0);
  for (int x = 4; x < 8; ++x) barriers[chart.mesh.find_halfedge(at(x, 8), at(x + 1, 8)).idx() / 2] = 1;
  const LineNetwork network(chart.mesh, lines_along(chart, {}, cut_along(chart.mesh, chain)).lines, barriers);
  EXPECT_TRUE(network.relax({network.steps_for(1)}, StopToken()).front().has_value());
  // After so many steps, the line is too close to the barrier.
  EXPECT_FALSE(network.relax({network.steps_for(8)}, StopToken()).front().has_value());
}

TEST(LineNetwork, MovesAJunctionToAnEdgeOnlyIfItsLinesMove) {
  const Chart chart = test::chart_of(test::flat_rectangle(6, 6, 6, 6));
  const HalfedgeHandle first = chart.mesh.halfedge_handle(FaceHandle(20));
  const FaceHandle face = chart.mesh.face_handle(first);
  const Planar a(0), b(edge_length(chart.mesh, first)), junction = 0.54 * b + 0.04 * apex_over(chart.mesh, first);
  std::vector<SurfaceLine> lines(2);
  lines[0] = {0, 1, {{face, junction, a, VertexHandle(), chart.mesh.from_vertex_handle(first), EdgeHandle()}}};
  lines[1] = {0, 2, {{face, junction, b, VertexHandle(), chart.mesh.to_vertex_handle(first), EdgeHandle()}}};
  const CutMask no_barriers(chart.mesh.n_edges(), 0);
  const LineNetwork network(chart.mesh, lines, no_barriers);
  const auto junction_after = [&](const std::vector<int>& steps) {
    return network.relax(steps, StopToken()).front()->start.place;
  };
  EXPECT_EQ(junction_after({1, 0}), junction);
  EXPECT_EQ(junction_after({1, 1}).imag(), 0);
}

FlattenInput bumpy_sheet() {
  return test::make_grid(12, 12, [](double s, double t) {
    return Eigen::Vector3d(6 * s, 6 * t, 0.5 * std::sin(6 * s) * std::cos(5 * t));
  });
}

TEST(StraightWalk, GoesBackAlongTheLineToTheEndOfAStep) {
  const Chart chart = test::chart_of(bumpy_sheet());
  const CutMask no_barriers(chart.mesh.n_edges(), 0);
  const StraightWalk walk(chart.mesh, no_barriers);
  const SurfacePoint start = point_on_edge(chart.mesh, chart.mesh.halfedge_handle(chart.mesh.face_handle(100)), 0.3);
  for (int k = 0; k < 12; ++k) {
    const Planar step = std::polar(0.4, 2 * kPi * k / 12);
    const auto line = walk.line(start, walk.step(start, step), 1);
    ASSERT_TRUE(line.has_value());
    EXPECT_NEAR(std::abs(line->leaving), std::abs(line->returning), 1e-9);
    EXPECT_LE(std::abs(line->leaving), 0.4 + 1e-9);
  }
}

TEST(StraightWalk, PassesAVertexThatHidesTheEnd) {
  // There are more than 360 degrees around the middle vertex of this sheet, so opposite points do not see each other.
  const FlattenInput sheet = test::saddle(2, 3);
  const Chart chart = test::chart_of(sheet);
  const CutMask no_barriers(chart.mesh.n_edges(), 0);
  const StraightWalk walk(chart.mesh, no_barriers);
  const VertexHandle middle(4);
  std::vector<HalfedgeHandle> around;
  for (const HalfedgeHandle h : chart.mesh.voh_range(middle)) around.push_back(h);
  const SurfacePoint from = point_on_edge(chart.mesh, around[0], 0.2);
  const SurfacePoint to = point_on_edge(chart.mesh, around[around.size() / 2], 0.2);
  const auto line = walk.line(from, to, 10);
  ASSERT_TRUE(line.has_value());
  EXPECT_TRUE(std::any_of(line->between.begin(), line->between.end(),
                          [&](const PathPoint& point) { return point.vertex == middle; }));
}

TEST(StraightWalk, StaysWhereABarrierIsInTheWay) {
  const Chart chart = test::chart_of(bumpy_sheet());
  const CutMask barriers(chart.mesh.n_edges(), 1);
  const StraightWalk walk(chart.mesh, barriers);
  const SurfacePoint start = SurfacePoint::in_face(chart.mesh.face_handle(100), Planar(0.01, 0.01));
  const SurfacePoint end = walk.step(start, Planar(1, 0));
  EXPECT_EQ(end.face, start.face);
  EXPECT_EQ(end.place, start.place);
}

}  // namespace
}  // namespace wirewarp::test_surface_lines
