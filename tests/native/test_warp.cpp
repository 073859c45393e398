// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of the shape ψ(h), of the gradient of its energy, and of the search for the lengths with the least distortion.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "numerics/optimize/active_set_bfgs.h"
#include "test_meshes.h"
#include "warp/outer/choose_variation.h"
#include "warp/topology/process_topology.h"

namespace wirewarp::test_warp {
namespace {

constexpr double kFree = std::numeric_limits<double>::infinity();

struct Case {
  explicit Case(const FlattenInput& input, NodeWeight weight = NodeWeight::length)
      : whole(test::chart_of(input)),
        chart(process_topology(whole).value_or(whole)),
        network(build_wire_network(chart)),
        warp(chart, network, weight, Inner::minimum),
        bounds(variation_bounds(chart, Options{})) {}
  OuterSolution solve() { return choose_variation(chart, warp, bounds); }
  Eigen::VectorXd no_variation() const { return Eigen::VectorXd::Zero(bounds.lower.size()); }
  Chart whole, chart;
  WireNetwork network;
  Warp warp;
  VariationBounds bounds;
};

FlattenInput dome(int n, int lines, double tolerance) {
  FlattenInput input = test::height_field(n, test::lopsided_dome);
  for (int i = 1; i <= lines; ++i) test::add_net(input, n, {i * n / (lines + 1)}, tolerance);
  return input;
}

/// Returns a saddle with a wire that touches nothing and a wire that ends inside. Both need helper wires to the
/// outline.
FlattenInput saddle_with_loose_wires(double tolerance) {
  const int n = 12;
  FlattenInput input = test::saddle(n, 0.4);
  test::add_wire(input, test::section(test::grid_row(n, 4), 3, 7), tolerance);
  test::add_wire(input, test::section(test::grid_column(n, n, 9), 0, 7), tolerance);
  return input;
}

/// Returns a dome with two holes, which need helper wires.
FlattenInput dome_with_two_holes(double tolerance) {
  FlattenInput input = test::flat_plate_with_two_holes(4);
  std::vector<int> across;
  for (int i = 0; i <= 8; ++i) across.push_back(test::nearest_vertex(input, {1.5, 0.25 * i, 0}));
  test::add_wire(input, across, tolerance);
  for (auto p : input.vertices.rowwise()) {
    const double x = p[0] - 1.3, y = p[1] - 0.8;
    p[2] = 0.5 * std::exp(-x * x - y * y);
  }
  return input;
}

TEST(Warp, GradientAgreesWithDifferences) {
  for (const FlattenInput& input : {dome(12, 2, 0.1), saddle_with_loose_wires(0.1), dome_with_two_holes(0.1)}) {
    for (const NodeWeight weight : {NodeWeight::length, NodeWeight::uniform}) {
      Case c(input, weight);
      const auto n = static_cast<Eigen::Index>(c.chart.wire_parts.size());
      Eigen::VectorXd h(n);
      for (Eigen::Index i = 0; i < n; ++i) h[i] = 0.01 * std::sin(3.0 + 2 * static_cast<double>(i));
      const Eigen::VectorXd gradient = c.warp.gradient(c.warp(h));
      const double step = 1e-5;
      for (Eigen::Index i = 0; i < n; ++i) {
        const Eigen::VectorXd e = step * Eigen::VectorXd::Unit(n, i);
        const double difference = (c.warp.shape_error(c.warp(h + e)) - c.warp.shape_error(c.warp(h - e))) / (2 * step);
        EXPECT_NEAR(gradient[i], difference, 1e-6 * gradient.lpNorm<Eigen::Infinity>()) << "wire " << i;
      }
    }
  }
}

TEST(Warp, TheGaussNewtonHessianIsExactWithoutDistortion) {
  FlattenInput flat = test::flat_rectangle(8, 8, 2, 1);
  test::add_net(flat, 8, {2, 4}, 0.1);
  Case c(flat);
  const std::vector<int> parts = c.bounds.elastic_parts();
  const auto n = static_cast<Eigen::Index>(parts.size());
  ASSERT_GE(n, 4);
  const Eigen::MatrixXd hessian = c.warp.gauss_newton_hessian(c.warp(c.no_variation()), parts);
  const double step = 1e-5, floor = 1e-3 * hessian.diagonal().mean();
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::VectorXd h = step * Eigen::VectorXd::Unit(n, i);
    const Eigen::VectorXd difference = c.warp.gradient(c.warp(h))(parts) - c.warp.gradient(c.warp(-h))(parts);
    EXPECT_LT((hessian.col(i) - difference / (2 * step)).lpNorm<Eigen::Infinity>(), floor) << "wire " << i;
  }
}

TEST(Warp, FollowingReachesTheSameShapeWithFewerFactorizations) {
  for (const FlattenInput& input : {dome(12, 2, 0.1), test::quarter_sphere(12), dome_with_two_holes(0.1)}) {
    Case c(input);
    const Eigen::VectorXd h = Eigen::VectorXd::LinSpaced(c.bounds.lower.size(), -0.02, 0.03);
    const WarpedShape start = c.warp(c.no_variation()), there = c.warp(h), followed = c.warp.follow(start, h);
    EXPECT_TRUE(followed.inner.is_minimum);
    EXPECT_LE(followed.inner.num_solves, there.inner.num_solves);
    EXPECT_NEAR(c.warp.shape_error(followed), c.warp.shape_error(there), 1e-9 * c.warp.shape_error(there));
  }
}

TEST(Warp, GradientCostsOneFactorizationHoweverManyWires) {
  for (const int lines : {1, 3, 5}) {
    Case c(dome(24, lines, 0.1));
    const WarpedShape shape = c.warp(Eigen::VectorXd::Zero(2 * lines));
    const int before = c.warp.inner_factorizations();
    c.warp.gradient(shape);
    EXPECT_EQ(c.warp.inner_factorizations() - before, 1);
  }
}

TEST(Warp, AsksBeforeEachFactorizationAndStopsAtOnce) {
  const Chart chart = test::chart_of(test::quarter_sphere(12));
  const WireNetwork network = build_wire_network(chart);
  int questions = 0, answers = std::numeric_limits<int>::max();
  const auto new_warp = [&] {
    return Warp(chart, network, NodeWeight::length, Inner::minimum,
                StopToken([&](const char*) { return ++questions <= answers; }));
  };
  Warp warp = new_warp();
  const int in_constructor = questions;
  const Eigen::VectorXd h = Eigen::VectorXd::Zero(chart.wire_parts.size());
  warp.gradient(warp(h));
  const int whole = questions;
  EXPECT_GE(whole, warp.inner_factorizations());
  for (answers = 0; answers < whole; ++answers) {
    questions = 0;
    if (answers < in_constructor) {
      EXPECT_THROW(new_warp(), Stopped);
      continue;
    }
    Warp stopped = new_warp();
    EXPECT_THROW(stopped.gradient(stopped(h)), Stopped);
    EXPECT_LE(stopped.inner_factorizations(), answers);
  }
}

/// Returns the outer side of a bent pipe, with a wire along every inner row.
FlattenInput half_tube(int rows) {
  FlattenInput input = test::make_grid(8, rows + 1, [](double s, double t) {
    const double around = 2 * (s - 0.5), along = 5 * t, radius = 3 + std::cos(around);
    return Eigen::Vector3d(std::sin(around), radius * std::sin(along), -radius * std::cos(along));
  });
  for (int j = 1; j <= rows; ++j) test::add_wire(input, test::grid_row(8, j), 0.05);
  return input;
}

TEST(ChooseVariation, TakesFewEvaluationsWithManyWires) {
  for (const FlattenInput& input : {dome(12, 5, 0.05), dome(16, 15, 0.05)}) {
    Case c(input);
    const OuterSolution solution = c.solve();
    EXPECT_TRUE(solution.converged);
    EXPECT_LE(solution.evaluations, 40) << input.wires.size() << " wires";
  }
  // Many wires divide a tube into narrow strips: with 200 wires, they are about 20 times as long as wide.
  for (const auto& [rows, most] : {std::pair(60, 10), std::pair(200, 30)}) {
    Case c(half_tube(rows));
    const OuterSolution solution = c.solve();
    EXPECT_TRUE(solution.converged);
    EXPECT_LE(solution.evaluations, most) << rows << " wires";
  }
}

/// Returns a pyramid, and a triangle on one side of its square base. A free wire is along this side. The other sides of
/// the triangle are 0.505 long, so the wire can be at most 1.01 long.
FlattenInput pyramid_beside_a_narrow_triangle() {
  const double low = std::sqrt(0.505 * 0.505 - 0.25);
  FlattenInput input = test::mesh_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 0.6}, {0.5, -low, 0}},
                                     {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {1, 0, 5}});
  test::add_wire(input, {0, 1}, kFree);
  return input;
}

TEST(ChooseVariation, BacksOffFromLengthsThatCannotBeKept) {
  Case c(pyramid_beside_a_narrow_triangle());
  const auto at = [&](double h) { return c.warp(Eigen::VectorXd::Constant(1, h)); };
  ASSERT_FALSE(at(0.015).inner.is_feasible);
  ASSERT_LT(c.warp.gradient(at(0.0))[0], 0) << "a longer wire lowers the distortion of the pyramid";
  const OuterSolution solution = c.solve();
  EXPECT_TRUE(solution.shape.inner.is_minimum);
  EXPECT_GT(solution.variation[0], 0);
  EXPECT_LT(solution.variation[0], 0.01);
  EXPECT_LT(solution.shape_error, c.warp.shape_error(at(0.0)));
}

TEST(ChooseVariation, WireWarpingHasZeroToleranceExceptForHelperWires) {
  Case elastic(dome(12, 2, 0.05));
  Options wirewarping = test::by(Method::wirewarping);
  const VariationBounds rigid_bounds = variation_bounds(elastic.chart, wirewarping);
  EXPECT_TRUE(rigid_bounds.elastic_parts().empty());
  Options least_norm;
  least_norm.inner = Inner::least_norm;
  EXPECT_TRUE(variation_bounds(elastic.chart, least_norm).elastic_parts().empty())
      << "this method has no gradient with respect to h";
  const OuterSolution as_rigid = choose_variation(elastic.chart, elastic.warp, rigid_bounds);
  Case rigid(dome(12, 2, 0));
  EXPECT_LT((as_rigid.shape.uv - rigid.solve().shape.uv).cwiseAbs().maxCoeff(), 1e-12);
  const Case joined(saddle_with_loose_wires(kFree));
  EXPECT_EQ(variation_bounds(joined.chart, wirewarping).elastic_parts(), (std::vector<int>{2, 3, 4}));
}

}  // namespace
}  // namespace wirewarp::test_warp
