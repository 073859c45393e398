// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "result/pack_boxes.h"
#include "result/pack_pieces.h"
#include "test_meshes.h"

namespace wirewarp::test_packing {
namespace {

using test::charts_of;
using test::planar_positions;

Positions2 turned(const Positions2& uv, double angle) {
  return uv * Eigen::Rotation2Dd(angle).toRotationMatrix().transpose();
}

/// The layout of the only chart, packed alone.
Positions2 pack_one(const Charts& charts, const Positions2& uv, bool mirror = false) {
  Options options;
  options.mirror = mirror;
  return pack_pieces(charts.charts, {uv}, options).at(0);
}

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
      // Near-square: the square around all is not much larger than the boxes, where there are enough to choose from.
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

TEST(PackBoxes, RoundingChoosesNothing) {
  Positions2 sizes(6, 2);
  sizes << 1, 2, 1, 2, 1, 2, 2, 1, 2, 1, 2, 1;
  const Positions2 corners = pack_boxes(sizes, 0.1);
  std::mt19937 random(4);
  std::uniform_real_distribution<double> noise(-1e-14, 1e-14);
  for (double& x : sizes.reshaped()) x += noise(random);
  EXPECT_LT((pack_boxes(sizes, 0.1) - corners).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(PackPieces, FirstWireStandsUprightWhateverTheLayoutsTurn) {
  FlattenInput input = test::flat_rectangle(6, 4, 3, 2);
  test::add_wire(input, test::grid_row(6, 2));  // from left to right
  const Charts charts = charts_of(input);
  const Positions2 uv = planar_positions(charts.charts[0]);
  for (const double angle : {0.0, 1.0, 2.5, -1.5}) {
    const Positions2 packed = pack_one(charts, turned(uv, angle));
    // x becomes y, and y becomes -x, from the right edge of a piece 2 wide.
    EXPECT_LT((packed.col(1) - uv.col(0)).cwiseAbs().maxCoeff(), 1e-14);
    EXPECT_LT((packed.col(0) - (2 - uv.col(1).array()).matrix()).cwiseAbs().maxCoeff(), 1e-14);
  }
}

TEST(PackPieces, MirroredPieceIsTheMirrorImage) {
  FlattenInput input = test::flat_rectangle(6, 4, 3, 2);
  test::add_wire(input, test::grid_column(6, 4, 3));  // upwards
  const Charts charts = charts_of(input);
  const Positions2 uv = planar_positions(charts.charts[0]);
  const Positions2 packed = pack_one(charts, turned(uv, 0.5), true);
  EXPECT_LT((packed.col(0) - (3 - uv.col(0).array()).matrix()).cwiseAbs().maxCoeff(), 1e-14);
  EXPECT_LT((packed.col(1) - uv.col(1)).cwiseAbs().maxCoeff(), 1e-14);
}

TEST(PackPieces, WithoutWiresTheLongestChainOfTheOutlineStandsUpright) {
  // A seam cuts off a strip: the seam and the rest of the outline are the chains of both pieces.
  FlattenInput input = test::flat_rectangle(8, 8, 4, 4);
  test::add_seam(input, test::grid_row(8, 2));
  const Charts charts = charts_of(input);
  ASSERT_EQ(charts.charts.size(), 2u);
  const std::vector<Positions2> layouts = {planar_positions(charts.charts[0]), planar_positions(charts.charts[1])};
  const std::vector<Positions2> packed = pack_pieces(charts.charts, layouts, {});
  for (const Positions2& piece : packed) {
    // Upright: both seam and outline chord run along x in the layout, 4 long.
    const Eigen::RowVector2d size = piece.colwise().maxCoeff() - piece.colwise().minCoeff();
    EXPECT_NEAR(size.y(), 4, 1e-14);
  }
}

TEST(PackPieces, AClosedOutlineStandsOnTheShortSideOfItsSmallestBox) {
  const Charts charts = charts_of(test::flat_rectangle(8, 2, 4, 1));
  const Positions2 packed = pack_one(charts, planar_positions(charts.charts[0]));
  EXPECT_NEAR(packed.col(0).maxCoeff(), 1, 1e-14);
  EXPECT_NEAR(packed.col(1).maxCoeff(), 4, 1e-14);
  const Positions2 again = pack_one(charts, turned(planar_positions(charts.charts[0]), 2));
  EXPECT_LT((again - packed).cwiseAbs().maxCoeff(), 1e-13) << "rounding chose the end that points up";
}

TEST(PackPieces, LengthsSurviveAndPiecesAreApart) {
  FlattenInput input = test::sphere_of_gores(6, 2, 8);
  const Charts charts = charts_of(input);
  ASSERT_EQ(charts.charts.size(), 6u);
  std::vector<Positions2> layouts;
  for (std::size_t c = 0; c < 6; ++c) {
    // Any layout serves: longitude against latitude, each turned differently.
    Positions2 uv(static_cast<Eigen::Index>(charts.charts[c].mesh.n_vertices()), 2);
    for (const VertexHandle v : charts.charts[c].mesh.vertices()) {
      const HalfEdgeMesh::Point& p = charts.charts[c].mesh.point(v);
      uv.row(v.idx()) << p[0] + 0.5 * p[1], p[2];
    }
    layouts.push_back(turned(uv, static_cast<double>(c)));
  }
  layouts[2].resize(0, 2);  // this piece has no layout
  const std::vector<Positions2> packed = pack_pieces(charts.charts, layouts, {});
  ASSERT_EQ(packed.size(), 6u);
  EXPECT_EQ(packed[2].rows(), 0);
  for (std::size_t c = 0; c < 6; ++c) {
    if (c == 2) continue;
    for (const EdgeHandle e : charts.charts[c].mesh.edges()) {
      const HalfedgeHandle h = charts.charts[c].mesh.halfedge_handle(e, 0);
      const int a = charts.charts[c].mesh.from_vertex_handle(h).idx();
      const int b = charts.charts[c].mesh.to_vertex_handle(h).idx();
      EXPECT_NEAR((packed[c].row(a) - packed[c].row(b)).norm(), (layouts[c].row(a) - layouts[c].row(b)).norm(), 4e-15);
    }
    EXPECT_GE(packed[c].minCoeff(), 0);
    for (std::size_t d = 0; d < c; ++d) {
      if (d == 2) continue;
      const Eigen::AlignedBox2d c_box(packed[c].colwise().minCoeff().transpose(),
                                      packed[c].colwise().maxCoeff().transpose());
      const Eigen::AlignedBox2d d_box(packed[d].colwise().minCoeff().transpose(),
                                      packed[d].colwise().maxCoeff().transpose());
      EXPECT_TRUE(c_box.intersection(d_box).isEmpty()) << c << " and " << d;
    }
  }
}

TEST(PackPieces, InARowTheyStandOnOneLineInTheirOrder) {
  FlattenInput input = test::flat_rectangle(12, 4, 6, 2);
  test::add_seam(input, test::grid_column(12, 4, 2));
  test::add_seam(input, test::grid_column(12, 4, 5));
  const Charts charts = charts_of(input);
  ASSERT_EQ(charts.charts.size(), 3u);
  std::vector<Positions2> layouts;
  for (const Chart& chart : charts.charts) layouts.push_back(planar_positions(chart));
  Options options;
  options.layout = PieceLayout::row;
  options.gap = 0.25;
  const std::vector<Positions2> packed = pack_pieces(charts.charts, layouts, options);
  double left = 0;
  for (const Positions2& piece : packed) {
    EXPECT_NEAR(piece.col(0).minCoeff(), left, 1e-13);
    EXPECT_EQ(piece.col(1).minCoeff(), 0);
    left = piece.col(0).maxCoeff() + 0.25 * std::sqrt(12.0);
  }
}

TEST(MirrorImage, TwiceIsTheSame) {
  const Positions2 uv = Positions2::Random(5, 2);
  EXPECT_EQ(mirror_image(mirror_image(uv)), uv);
  EXPECT_EQ(mirror_image(uv).col(0), -uv.col(0));
}

}  // namespace
}  // namespace wirewarp::test_packing
