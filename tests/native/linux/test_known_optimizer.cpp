// SPDX-License-Identifier: GPL-3.0-or-later
// Compares solutions of the outer problem with those of NLopt. The outer problem chooses the wires' variations h, so
// that the shape error E is least. From the same start, with the same E and gradient, NLopt finds no better minimum.
#include <gtest/gtest.h>
#include <nlopt.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <vector>

#include "test_meshes.h"
#include "warp/outer/choose_variation.h"
#include "warp/topology/process_topology.h"

namespace wirewarp::test_known_optimizer {
namespace {

constexpr double kNothingBetter = 1e-4;  // relative difference by which NLopt may be better
constexpr double kFree = std::numeric_limits<double>::infinity();

/// E(ψ(h)) as a function of the elastic parts' h, in the form that NLopt calls.
struct ShapeErrorOf {
  Warp& warp;
  std::vector<int> parts;
  Eigen::VectorXd variation;  // h of all parts
  double least = std::numeric_limits<double>::infinity();
  bool is_defined = true;  // whether ψ(h) was defined at every h so far

  static double evaluate(unsigned size, const double* elastic, double* gradient, void* data) {
    ShapeErrorOf& self = *static_cast<ShapeErrorOf*>(data);
    self.variation(self.parts) = Eigen::Map<const Eigen::VectorXd>(elastic, size);
    const WarpedShape shape = self.warp(self.variation);
    if (!shape.inner.is_feasible) {
      self.is_defined = false;
      return std::numeric_limits<double>::infinity();
    }
    if (gradient != nullptr) Eigen::Map<Eigen::VectorXd>(gradient, size) = self.warp.gradient(shape)(self.parts);
    const double value = self.warp.shape_error(shape);
    self.least = std::min(self.least, value);
    return value;
  }
};

double least_shape_error(nlopt_algorithm algorithm, Warp& warp, const VariationBounds& bounds,
                         const Eigen::VectorXd& start) {
  ShapeErrorOf function{warp, bounds.elastic_parts(), start};
  const Eigen::VectorXd lower = bounds.lower(function.parts), upper = bounds.upper(function.parts);
  Eigen::VectorXd elastic = start(function.parts);
  const std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)> optimizer(
      nlopt_create(algorithm, static_cast<unsigned>(elastic.size())), &nlopt_destroy);
  nlopt_set_lower_bounds(optimizer.get(), lower.data());
  nlopt_set_upper_bounds(optimizer.get(), upper.data());
  nlopt_set_min_objective(optimizer.get(), &ShapeErrorOf::evaluate, &function);
  nlopt_set_ftol_rel(optimizer.get(), 1e-10);
  nlopt_set_maxeval(optimizer.get(), 300);
  double last = 0;
  // The returned code is ignored, because near the minimum, LD_LBFGS often ends with a failed line search.
  nlopt_optimize(optimizer.get(), elastic.data(), &last);
  EXPECT_TRUE(function.is_defined);
  return function.least;
}

void expect_nothing_better(const FlattenInput& input) {
  const Chart whole = test::chart_of(input), chart = process_topology(whole).value_or(whole);
  const WireNetwork network = build_wire_network(chart);
  for (const NodeWeight weight : {NodeWeight::length, NodeWeight::uniform}) {
    Warp warp(chart, network, weight, Inner::minimum);
    const VariationBounds bounds = variation_bounds(chart, Options{});
    ASSERT_FALSE(bounds.elastic_parts().empty());
    const OuterSolution start = start_variation(chart, warp, bounds);
    const OuterSolution ours = choose_variation(chart, warp, bounds);
    for (const nlopt_algorithm algorithm : {NLOPT_LD_SLSQP, NLOPT_LD_LBFGS}) {
      const double theirs = least_shape_error(algorithm, warp, bounds, start.variation);
      EXPECT_LT(theirs, start.shape_error);
      EXPECT_LE(ours.shape_error, theirs * (1 + kNothingBetter)) << nlopt_algorithm_name(algorithm);
    }
  }
}

FlattenInput elastic(FlattenInput input, double tolerance) {
  for (Wire& wire : input.wires) wire.tolerance = tolerance;
  return input;
}

TEST(KnownOptimizer, FindsNothingBetterOnAQuarterSphere) {
  for (const double tolerance : {0.03, kFree}) expect_nothing_better(elastic(test::quarter_sphere(16), tolerance));
}

TEST(KnownOptimizer, FindsNothingBetterOnASaddle) {
  FlattenInput input = test::saddle(16, 0.3);
  for (const int line : {3, 7, 12}) {
    test::add_wire(input, test::grid_row(16, line), 0.03);
    test::add_wire(input, test::grid_column(16, 16, line), 0.1);
  }
  expect_nothing_better(input);
}

TEST(KnownOptimizer, FindsNothingBetterOnAGore) {
  const int gores = 6, n = 6;
  FlattenInput input = test::sphere_of_gores(gores, n, 16);
  for (const int ring : {3, 7, 11}) test::add_wire(input, test::tube_ring(gores * n, ring), 0.05);
  expect_nothing_better(input);
}

/// Helper wires connect the ring with the outline, and may have any length.
TEST(KnownOptimizer, FindsNothingBetterWithARingThatTouchesNothing) {
  FlattenInput input = test::saddle(16, 0.3);
  test::add_wire(input, test::grid_square(16, 8, 8, 4), 0.05);
  expect_nothing_better(input);
}

}  // namespace
}  // namespace wirewarp::test_known_optimizer
