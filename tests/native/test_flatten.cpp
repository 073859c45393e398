// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the whole pipeline.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "base/planar.h"
#include "disguise.h"
#include "error_of.h"
#include "test_meshes.h"

namespace wirewarp::test_flatten {
namespace {

using test::by;
using test::misfit;

// Allowed difference of positions, as a share of the piece's size. The refined method stops when the next step would
// gain less than 1e-9 of its objective.
constexpr double kSame = 1e-6;
constexpr Method kMethods[] = {Method::wirewarp_plus_plus, Method::refined};

Positions2 mirrored(Positions2 uv) {
  uv.col(0) *= -1;
  return uv;
}

FlattenInput gores_with_a_wire() {
  const int gores = 4, n = 6, rings = 12;
  FlattenInput input = test::sphere_of_gores(gores, n, rings);
  test::add_wire(input, test::tube_ring(gores * n, rings / 2 - 1), 0, "waist");  // ring 0 is the first above the pole
  return input;
}

FlattenInput sheet_with_a_dart(int n, double bend) {
  FlattenInput input = test::height_field(
      n, [&](double x, double y) { return -bend * (x * x + y * y + 0.3 * x * y * y + 0.2 * x * x * x); });
  std::vector<int> dart = test::grid_column(n, n, n / 2);
  dart.resize(static_cast<std::size_t>(n) / 2 + 1);
  test::add_seam(input, dart);
  test::add_wire(input, test::grid_row(n, n / 4), 0, "across the dart");
  return input;
}

FlattenResult expect_guarantees(const FlattenInput& input, const Options& options) {
  FlattenResult result = flatten(input, options);
  test::expect_good(input, result, options);
  for (const Piece& piece : result.pieces) {
    EXPECT_LT(piece.report.constraint_residual, 1e-12);
    EXPECT_EQ(piece.report.termination, Termination::converged) << piece.report.message;
    if (result.method != "refined") {
      EXPECT_LT(piece.report.projected_gradient, 1e-10);
      EXPECT_LE(piece.report.factorizations, 1);
    }
  }
  return result;
}

TEST(Flatten, DevelopablePiecesAreIsometric) {
  FlattenInput cylinder = test::cylinder_patch(24, 6, 1, kPi, 2);
  test::add_wire(cylinder, test::grid_row(24, 2));
  FlattenInput cone = test::cone_patch(24, 6, 0.5, 2, 0.4, 5);
  test::add_wire(cone, test::grid_column(24, 6, 10));
  FlattenInput tube = test::cylinder_tube(24, 6, 1, 2);
  test::add_seam(tube, test::tube_line(24, 6, 3));
  test::add_wire(tube, test::tube_ring(24, 2));
  const FlattenInput plate = test::flat_plate_with_wires(4);
  for (const FlattenInput& input : {cylinder, cone, tube, plate, sheet_with_a_dart(8, 0)}) {
    for (const Method method : kMethods) {
      const FlattenResult result = expect_guarantees(input, by(method));
      for (const Piece& piece : result.pieces) {
        EXPECT_LT(piece.metrics.arap_energy, 1e-20);
        EXPECT_NEAR(piece.metrics.face_aspect_ratio.maxCoeff(), 1, 1e-10);
        EXPECT_NEAR(piece.metrics.area_2d, piece.metrics.area_3d, 1e-10 * piece.metrics.area_3d);
      }
    }
  }
}

TEST(Flatten, FollowsRigidMotionAndScale) {
  const FlattenInput input = gores_with_a_wire();
  FlattenInput moved = input;
  const double scale = 250;
  const Eigen::Matrix3d turn = (Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, 3).normalized())).toRotationMatrix();
  moved.vertices = scale * input.vertices * turn.transpose();
  moved.vertices.rowwise() += Eigen::RowVector3d(40, -7, 11);
  for (const Method method : kMethods) {
    const FlattenResult before = flatten(input, by(method)), after = flatten(moved, by(method));
    for (std::size_t i = 0; i < before.pieces.size(); ++i) {
      EXPECT_LT(misfit(scale * before.pieces[i].vertices, after.pieces[i].vertices), kSame * scale);
      EXPECT_NEAR(after.pieces[i].metrics.arap_energy, before.pieces[i].metrics.arap_energy, 1e-9);
    }
  }
}

TEST(Flatten, PiecesDoNotDependOnHowTheSurfaceIsGiven) {
  // The surface is not symmetric, because wires of a symmetric piece may buckle to either side.
  FlattenInput dome = test::jittered_grid(12, 0.3, test::over_square(test::lopsided_dome));
  test::add_net(dome, 12, {4, 9});
  for (const FlattenInput& input : {sheet_with_a_dart(12, 0.3), dome}) {
    for (const Method method : kMethods) {
      const FlattenResult before = flatten(input, by(method)), after = flatten(test::disguised(input), by(method));
      const Eigen::Index last = input.faces.rows() - 1;
      Positions2 corners_before(3 * input.faces.rows(), 2), corners_after = corners_before;
      for (Eigen::Index f = 0; f <= last; ++f) {
        for (const int k : {0, 1, 2}) {
          corners_before.row(3 * f + k) = before.corner_uv.block<1, 2>(last - f, 2 * std::array{1, 0, 2}[k]);
          corners_after.row(3 * f + k) = after.corner_uv.block<1, 2>(f, 2 * k);
        }
      }
      const bool is_refined = method == Method::refined;
      // Newton's iteration may stop a step earlier or later. Objectives agree up to the tolerance of the iteration, and
      // positions up to the square root of this tolerance.
      if (is_refined) {
        EXPECT_NEAR(after.pieces[0].report.objective, before.pieces[0].report.objective, 1e-11);
      }
      EXPECT_LT(misfit(mirrored(corners_before), corners_after), is_refined ? 1e-5 : kSame);
    }
  }
}

TEST(Flatten, MirrorReturnsTheMirrorImage) {
  const FlattenInput input = sheet_with_a_dart(12, 0.3);
  Options options;
  options.mirror = true;
  const FlattenResult inside = expect_guarantees(input, options);
  EXPECT_LT(misfit(mirrored(flatten(input).pieces[0].vertices), inside.pieces[0].vertices), 1e-12);
}

/// Returns a quarter sphere with columns that are denser towards one side. With grading 1, the columns are evenly
/// spaced.
FlattenInput graded_quarter_sphere(int n, double grading) {
  const auto graded = [&](double s) { return s + (1 - 1 / grading) * s * (1 - s) / (2 - 1 / grading); };
  FlattenInput input = test::make_grid(2 * n, n, [&](double s, double t) {
    const double longitude = kPi * graded(s), latitude = t * kPi * 75 / 180;
    return Eigen::Vector3d(std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
                           std::sin(latitude));
  });
  test::add_wire(input, test::grid_row(2 * n, n / 2), 0, "parallel");
  return input;
}

double energy(const FlattenInput& input, NodeWeight weight) {
  Options options = by(Method::wirewarp_plus_plus);
  options.node_weight = weight;
  return flatten(input, options).pieces[0].metrics.arap_energy;
}

TEST(Flatten, WirewarpingConvergesWhenTheSurfaceIsRefined) {
  double previous = energy(test::quarter_sphere(24), NodeWeight::length);
  double change = 1;
  for (const int n : {36, 54, 81}) {  // edges become shorter by a factor of 1.5
    const double refined = energy(test::quarter_sphere(n), NodeWeight::length);
    EXPECT_LT(std::abs(refined - previous), 0.8 * change) << n;
    change = std::abs(refined - previous);
    previous = refined;
  }
  EXPECT_LT(change, 0.01 * previous);
}

TEST(Flatten, TheGradingOfTheMeshMattersOnlyForTheUniformWeight) {
  const int n = 48;
  const auto change = [&](NodeWeight weight) {
    const double even = energy(graded_quarter_sphere(n, 1), weight);
    return std::abs(energy(graded_quarter_sphere(n, 5), weight) - even) / even;
  };
  EXPECT_LT(change(NodeWeight::length), 0.01);
  EXPECT_GT(change(NodeWeight::uniform), 5 * change(NodeWeight::length));
}

TEST(Measure, AgreesWithTheResultOfFlatten) {
  const FlattenInput input = gores_with_a_wire();
  const FlattenResult flat = flatten(input);
  const FlattenResult measured = measure(input, flat.corner_uv);
  EXPECT_EQ(measured.method, "measure");
  for (std::size_t i = 0; i < flat.pieces.size(); ++i) {
    EXPECT_FALSE(measured.pieces[i].error.has_value());
    EXPECT_EQ(measured.pieces[i].report.termination, Termination::measured);
    EXPECT_DOUBLE_EQ(measured.pieces[i].metrics.arap_energy, flat.pieces[i].metrics.arap_energy);
  }
  for (std::size_t i = 0; i < flat.seams.size(); ++i) {
    EXPECT_EQ(measured.seams[i].length_2d, flat.seams[i].length_2d);
  }
}

TEST(Measure, FindsLengthsThatAFlatteningDoesNotKeep) {
  const FlattenInput input = test::quarter_sphere(8);
  const FlattenResult measured = measure(input, 1.01 * flatten(input).corner_uv);
  EXPECT_TRUE(test::expect_error(measured.pieces[0].error, ErrorCode::lengths_not_kept).has_layout);
  EXPECT_NEAR(measured.wires[0].length_2d, 1.01 * measured.wires[0].length_3d, 1e-9);
}

TEST(Flatten, StagesAreReportedInTheirOrder) {
  FlattenInput input = test::saddle(8, 0.5);
  test::add_wire(input, test::grid_row(8, 4), 0.05);
  Options options = test::by(Method::wirewarp_plus_plus);
  std::vector<std::string> stages;
  flatten(input, options, [&](const std::string& stage, double) {
    if (stages.empty() || stages.back() != stage) stages.push_back(stage);
    return true;
  });
  EXPECT_EQ(stages, (std::vector<std::string>{"charts", "wires", "interior", "lengths", "measure"}));
}

}  // namespace
}  // namespace wirewarp::test_flatten
