// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>

#include "result/pack_boxes.h"
#include "result/pack_pieces.h"
#include "surface/orientation/rising_direction.h"
#include "surface/orientation/straightest_outline.h"
#include "surface/orientation/upright_direction.h"
#include "test_meshes.h"

namespace wirewarp::test_layout {
namespace {

using test::charts_of;
using test::planar_positions;

Positions2 turned(const Positions2& uv, double angle) {
  return uv * Eigen::Rotation2Dd(angle).toRotationMatrix().transpose();
}

Positions2 pack_one(const Charts& charts, const Positions2& uv) { return pack_pieces(charts.charts, {uv}, {}).at(0); }

TEST(PackBoxes, NoTwoOverlapAndTheGapIsKept) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> side(0.1, 3);
  for (const int count : {1, 2, 3, 10, 60}) {
    for (const double gap : {0.0, 0.2}) {
      Positions2 sizes(count, 2);
      for (double& x : sizes.reshaped()) x = side(random);
      const Positions2 corners = pack_boxes(sizes, gap);
      EXPECT_EQ(corners.minCoeff(), 0);
      for (int a = 0; a < count; ++a) {
        for (int b = 0; b < a; ++b) {
          double apart = -1;
          for (int k = 0; k < 2; ++k) {
            apart = std::max(
                {apart, corners(a, k) - corners(b, k) - sizes(b, k), corners(b, k) - corners(a, k) - sizes(a, k)});
          }
          EXPECT_GE(apart, gap == 0 ? -1e-14 : gap - 1e-5) << a << " and " << b << " of " << count;
        }
      }
      // With enough boxes, the square around all boxes is not much larger than their total area.
      const double extent = (corners + sizes).maxCoeff();
      const double area = ((sizes.array() + gap).col(0) * (sizes.array() + gap).col(1)).sum();
      if (count >= 10) {
        EXPECT_LT(extent * extent, 1.6 * area) << count;
      }
    }
  }
}

TEST(PackBoxes, FourSquaresMakeASquare) {
  const Positions2 corners = pack_boxes(Positions2::Ones(4, 2), 0.5);
  EXPECT_NEAR((corners.array() + 1).maxCoeff(), 2.5, 1e-14);
}

TEST(PackBoxes, DoesNotDependOnRounding) {
  Positions2 sizes(6, 2);
  sizes << 1, 2, 1, 2, 1, 2, 2, 1, 2, 1, 2, 1;
  const Positions2 corners = pack_boxes(sizes, 0.1);
  std::mt19937 random(4);
  std::uniform_real_distribution<double> noise(-1e-14, 1e-14);
  for (double& x : sizes.reshaped()) x += noise(random);
  EXPECT_LT((pack_boxes(sizes, 0.1) - corners).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(PackPieces, TheFirstWireIsUprightHoweverTheShapeIsTurned) {
  FlattenInput input = test::flat_rectangle(6, 4, 3, 2);
  test::add_wire(input, test::grid_row(6, 2));
  const Charts charts = charts_of(input);
  const Positions2 uv = planar_positions(charts.charts[0]);
  for (const double angle : {0.0, 2.5}) {
    const Positions2 packed = pack_one(charts, turned(uv, angle));
    // The wire along x becomes upright. The new y is the old x, and the new x is 2 minus the old y, because the piece
    // was 2 high.
    EXPECT_LT((packed.col(1) - uv.col(0)).cwiseAbs().maxCoeff(), 1e-14);
    EXPECT_LT((packed.col(0) - (2 - uv.col(1).array()).matrix()).cwiseAbs().maxCoeff(), 1e-14);
  }
}

TEST(PackPieces, AClosedOutlineIsUprightInItsSmallestBox) {
  const Charts charts = charts_of(test::flat_rectangle(8, 2, 4, 1));
  const Positions2 packed = pack_one(charts, planar_positions(charts.charts[0]));
  EXPECT_NEAR(packed.col(0).maxCoeff(), 1, 1e-14);
  EXPECT_NEAR(packed.col(1).maxCoeff(), 4, 1e-14);
  const Positions2 again = pack_one(charts, turned(planar_positions(charts.charts[0]), 2));
  EXPECT_LT((again - packed).cwiseAbs().maxCoeff(), 1e-13) << "rounding errors decide which end points up";
}

Options by(Orientation orientation) {
  Options options;
  options.orientation = orientation;
  return options;
}

TEST(Grain, PiecesWithoutTheGrainWireUseTheirFirstWire) {
  FlattenInput input = test::flat_rectangle(6, 4, 3, 2);
  test::add_seam(input, test::grid_column(6, 4, 3));
  test::add_wire(input, test::grid_column(6, 4, 1));
  test::add_wire(input, {test::grid_row(6, 2)[4], test::grid_row(6, 2)[5]});
  const Charts charts = charts_of(input);
  ASSERT_EQ(charts.charts.size(), 2u);
  Options options;
  for (const int wire : {0, 1}) {
    options.grain = wire;
    EXPECT_EQ(upright_direction(charts.charts[0], planar_positions(charts.charts[0]), options).x(), 0) << wire;
    EXPECT_EQ(upright_direction(charts.charts[1], planar_positions(charts.charts[1]), options).y(), 0) << wire;
  }
}

TEST(Grain, PiecesWithoutTheGrainWireMayHaveTheSameSideUpAsTheModel) {
  FlattenInput input = test::flat_rectangle(6, 4, 3, 2);
  input.vertices = input.vertices * Eigen::AngleAxisd(-1, Eigen::Vector3d::UnitX()).toRotationMatrix();  // y rises
  test::add_seam(input, test::grid_column(6, 4, 3));
  test::add_wire(input, {test::grid_row(6, 1)[0], test::grid_row(6, 1)[1]});  // along x
  test::add_wire(input, {test::grid_row(6, 2)[4], test::grid_row(6, 2)[5]});  // along x, in the other piece
  const Charts charts = charts_of(input);
  ASSERT_EQ(charts.charts.size(), 2u);
  Options options = by(Orientation::grain);
  options.grain_angle = 0.5;
  const auto up = [&](std::size_t chart) {
    const Chart& own = charts.charts[chart];
    Positions2 uv(own.mesh.n_vertices(), 2);  // as if the sheet were not tilted
    for (const VertexHandle v : own.mesh.vertices()) {
      const OpenMesh::Vec3d& p = own.mesh.point(v);
      uv.row(v.idx()) << p[0], std::cos(1) * p[1] + std::sin(1) * p[2];
    }
    return Eigen::Vector2d(upright_direction(own, uv, options).normalized());
  };
  const Eigen::Vector2d by_model(0, 1), by_wire(std::cos(0.5), -std::sin(0.5));
  EXPECT_LT((up(0) - by_model).norm(), 1e-12) << "no grain wire";
  EXPECT_LT((up(1) - by_model).norm(), 1e-12);
  options.grain = 0;
  EXPECT_LT((up(0) - by_wire).norm(), 1e-12);
  EXPECT_LT((up(1) - by_model).norm(), 1e-12) << "another wire says nothing about the grain";
}

/// Returns a sheet with a lower side that is straight except for a kink of 2 degrees, and a longer, rounded upper side.
FlattenInput hill(int nx) {
  return test::make_grid(nx, 2, [](double s, double t) {
    const double kinked = 0.05 * std::abs(s - 0.5);
    return Eigen::Vector3d(3 * s, (1 - t) * kinked + t * (1 + 3 * s * (1 - s)), 0);
  });
}

TEST(StraightestOutline, IsTheLongestSideWithLittleTurning) {
  for (const int nx : {6, 200}) {
    Chart chart = test::chart_of(hill(nx));
    const Positions2 uv = planar_positions(chart);
    // The loop may begin anywhere, even in the middle of the straight side.
    HalfEdgeChain& loop = chart.boundary_loops[0];
    for (std::size_t k = 0; k < loop.size(); ++k) {
      std::rotate(loop.begin(), loop.begin() + 1, loop.end());
      const Eigen::Vector2d along = straightest_outline(chart, uv);
      EXPECT_NEAR(along.x(), 3, 1e-12) << "from left to right, with the piece on the left";
      EXPECT_NEAR(along.y(), 0, 1e-12);
    }
  }
}

TEST(RisingDirection, IsTheMeanGradientOfTheTriangles) {
  const FlattenInput input = test::saddle(6, 0.4);
  const Chart chart = test::chart_of(input);
  Positions2 uv = planar_positions(chart);
  uv.col(0).array() += 0.2 * uv.col(1).array().square();
  const Eigen::Vector3d up = Eigen::Vector3d(1, 2, 3).normalized();
  Eigen::Vector2d sum(0, 0);
  for (const FaceHandle f : chart.mesh.faces()) {
    Eigen::Matrix2d edges;
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

TEST(RisingDirection, ALevelPieceIsAlignedByItsWire) {
  FlattenInput dome = test::height_field(8, [](double x, double y) { return 1e6 - 0.3 * (x * x + y * y); });
  test::add_wire(dome, test::grid_column(8, 8, 4));
  for (const FlattenInput& input : {dome, test::flat_rectangle(4, 4, 1, 2)}) {
    EXPECT_EQ(flatten(input, by(Orientation::up)).corner_uv, flatten(input).corner_uv);
  }
}

TEST(UprightPair, AtEqualHeightsDoesNotDependOnTheNumbering) {
  // All vertices of the lower side are equally low, and all vertices of the upper side are equally high. Among these,
  // the left end of each side must be chosen.
  const FlattenInput sheet = test::flat_rectangle(4, 2, 2, 3);
  FlattenInput renumbered = sheet;
  const auto last = static_cast<int>(sheet.vertices.rows()) - 1;
  renumbered.vertices = sheet.vertices.colwise().reverse().eval();
  renumbered.faces = (last - sheet.faces.array()).matrix();
  for (const FlattenInput& input : {sheet, renumbered}) {
    const Chart chart = test::chart_of(input);
    const Positions2 uv = planar_positions(chart);
    const VertexPair pair = upright_pair(chart, uv, by(Orientation::up));
    EXPECT_EQ(uv.row(pair[0]), Eigen::RowVector2d(0, 0));
    EXPECT_EQ(uv.row(pair[1]), Eigen::RowVector2d(0, 3));
  }
}

}  // namespace
}  // namespace wirewarp::test_layout
