// SPDX-License-Identifier: GPL-3.0-or-later
// What stands upright in a packed piece: the wire of the grain, the longest straight stretch of outline, up in space.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "surface/orientation/rising_direction.h"
#include "surface/orientation/straightest_outline.h"
#include "surface/orientation/upright_direction.h"
#include "test_meshes.h"

namespace wirewarp::test_orientation {
namespace {

using test::charts_of;
using test::planar_positions;

Options by(Orientation orientation) {
  Options options;
  options.orientation = orientation;
  return options;
}

Options grain(int wire) {
  Options options;
  options.grain = wire;
  return options;
}

TEST(Grain, TheChosenWireStandsUpright) {
  FlattenInput input = test::flat_rectangle(6, 4, 3, 2);
  test::add_wire(input, test::grid_row(6, 1));
  test::add_wire(input, test::grid_column(6, 4, 2));
  const Charts charts = charts_of(input);
  const Chart& chart = charts.charts[0];
  const Positions2 uv = planar_positions(chart);
  EXPECT_EQ(upright_direction(chart, uv, grain(-1)).normalized(), Eigen::Vector2d(1, 0));
  EXPECT_EQ(upright_direction(chart, uv, grain(0)).normalized(), Eigen::Vector2d(1, 0));
  EXPECT_EQ(upright_direction(chart, uv, grain(1)).normalized(), Eigen::Vector2d(0, 1));
}

TEST(Grain, APieceThatItDoesNotRunThroughTakesItsFirstWire) {
  FlattenInput input = test::flat_rectangle(6, 4, 3, 2);
  test::add_seam(input, test::grid_column(6, 4, 3));
  test::add_wire(input, test::grid_column(6, 4, 1));
  test::add_wire(input, {test::grid_row(6, 2)[4], test::grid_row(6, 2)[5]});
  const Charts charts = charts_of(input);
  ASSERT_EQ(charts.charts.size(), 2u);
  for (const int wire : {0, 1}) {
    EXPECT_EQ(upright_direction(charts.charts[0], planar_positions(charts.charts[0]), grain(wire)).x(), 0) << wire;
    EXPECT_EQ(upright_direction(charts.charts[1], planar_positions(charts.charts[1]), grain(wire)).y(), 0) << wire;
  }
}

/// A sheet whose lower side is straight but for a kink of 2 degrees, and whose longer upper side is a round hill.
FlattenInput hill(int nx) {
  return test::make_grid(nx, 2, [](double s, double t) {
    const double kinked = 0.05 * std::abs(s - 0.5);
    return Eigen::Vector3d(3 * s, (1 - t) * kinked + t * (1 + 3 * s * (1 - s)), 0);
  });
}

TEST(StraightestOutline, IsTheLongestSideThatHardlyTurns) {
  for (const int nx : {6, 40, 200}) {
    Charts charts = charts_of(hill(nx));
    Chart& chart = charts.charts[0];
    const Positions2 uv = planar_positions(chart);
    // Wherever the loop begins: in the middle of the side too.
    HalfEdgeChain& loop = chart.boundary_loops[0];
    for (std::size_t k = 0; k < loop.size(); ++k) {
      std::rotate(loop.begin(), loop.begin() + 1, loop.end());
      const Eigen::Vector2d along = straightest_outline(chart, uv);
      EXPECT_NEAR(along.x(), 3, 1e-12) << "from left to right, the piece on the left";
      EXPECT_NEAR(along.y(), 0, 1e-12);
    }
  }
}

TEST(StraightestOutline, AlsoRoundAHoleAndWhateverTheWires) {
  FlattenInput input = test::flat_plate_with_two_holes(4);
  test::add_wire(input, {test::nearest_vertex(input, {1.5, 0, 0}), test::nearest_vertex(input, {1.5, 0.25, 0})});
  const Charts charts = charts_of(input);
  const Chart& chart = charts.charts[0];
  const Positions2 uv = planar_positions(chart);
  const Eigen::Vector2d along = upright_direction(chart, uv, by(Orientation::boundary));
  EXPECT_NEAR(std::abs(along.x()), 3, 1e-12);
  EXPECT_NEAR(along.y(), 0, 1e-12);
}

TEST(RisingDirection, UpInSpaceIsUpInThePiece) {
  FlattenInput input = test::cylinder_patch(12, 6, 1, 3, 2);
  test::add_wire(input, test::grid_row(12, 2));  // level: by wire it would lie on its side
  Options options = by(Orientation::up);
  for (const double sign : {1.0, -1.0}) {
    for (const bool is_mirrored : {false, true}) {
      options.up = {0, 0, 1e-200 * sign};
      options.mirror = is_mirrored;
      const FlattenResult result = flatten(input, options);
      const Piece& piece = result.pieces.at(0);
      for (int v = 0; v < piece.vertices.rows(); ++v) {
        const double z = input.vertices(piece.source_vertex[static_cast<std::size_t>(v)], 2);
        const double height = sign > 0 ? z - input.vertices.col(2).minCoeff() : input.vertices.col(2).maxCoeff() - z;
        EXPECT_NEAR(piece.vertices(v, 1), height, 1e-9);
      }
    }
  }
}

TEST(RisingDirection, IsTheMeanOfTheTrianglesGradients) {
  const FlattenInput input = test::saddle(6, 0.4);
  const Charts charts = charts_of(input);
  const Chart& chart = charts.charts[0];
  Positions2 uv = planar_positions(chart);
  uv.col(0).array() += 0.2 * uv.col(1).array().square();
  const Eigen::Vector3d up = Eigen::Vector3d(1, 2, 3).normalized();
  Eigen::Vector2d sum(0, 0);
  for (const FaceHandle f : chart.mesh.faces()) {
    Eigen::Matrix2d edges;  // rows
    Eigen::Vector2d rises;
    const HalfedgeHandle h = chart.mesh.halfedge_handle(f);
    const VertexHandle a = chart.mesh.from_vertex_handle(h), b = chart.mesh.to_vertex_handle(h);
    const VertexHandle c = chart.mesh.to_vertex_handle(chart.mesh.next_halfedge_handle(h));
    edges << uv.row(b.idx()) - uv.row(a.idx()), uv.row(c.idx()) - uv.row(a.idx());
    const auto rise = [&](VertexHandle v) {
      const HalfEdgeMesh::Point p = chart.mesh.point(v) - chart.mesh.point(a);
      return up.dot(Eigen::Vector3d(p[0], p[1], p[2]));
    };
    rises << rise(b), rise(c);
    sum += edges.determinant() / 2 * edges.inverse() * rises;
  }
  EXPECT_LT((rising_direction(chart, uv, 7 * up).normalized() - sum.normalized()).norm(), 1e-12);
}

TEST(RisingDirection, ALevelPieceIsTurnedByItsWire) {
  FlattenInput dome = test::make_grid(8, 8, [](double s, double t) {
    const double x = 2 * s - 1, y = 2 * t - 1;
    return Eigen::Vector3d(x, y, 1e6 - 0.3 * (x * x + y * y));
  });
  test::add_wire(dome, test::grid_column(8, 8, 4));
  for (const FlattenInput& input : {dome, test::flat_rectangle(4, 4, 1, 2)}) {
    EXPECT_EQ(flatten(input, by(Orientation::up)).corner_uv, flatten(input).corner_uv);
  }
}

TEST(UprightPair, OfVerticesAtOneHeightDoesNotDependOnTheNumbering) {
  // The whole lower and the whole upper side are at one height.
  const FlattenInput sheet = test::flat_rectangle(4, 2, 2, 3);
  FlattenInput renumbered = sheet;
  const auto last = static_cast<int>(sheet.vertices.rows()) - 1;
  renumbered.vertices = sheet.vertices.colwise().reverse().eval();
  renumbered.faces = (last - sheet.faces.array()).matrix();
  for (const FlattenInput& input : {sheet, renumbered}) {
    const Charts charts = charts_of(input);
    const Positions2 uv = planar_positions(charts.charts[0]);
    const VertexPair pair = upright_pair(charts.charts[0], uv, by(Orientation::up));
    EXPECT_EQ(uv.row(pair[0]), Eigen::RowVector2d(0, 0));
    EXPECT_EQ(uv.row(pair[1]), Eigen::RowVector2d(0, 3));
  }
}

}  // namespace
}  // namespace wirewarp::test_orientation
