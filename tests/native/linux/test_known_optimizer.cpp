// SPDX-License-Identifier: GPL-3.0-or-later
// Compares solutions of the outer problem with those of NLopt. From the same h0, with the same E and gradient, NLopt
// finds no better minimum.
#include <gtest/gtest.h>
#include <nlopt.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "test_meshes.h"
#include "warp/outer/choose_variation.h"
#include "warp/topology/process_topology.h"

namespace wirewarp::test_known_optimizer {
namespace {

constexpr double kNothingBetter = 1e-4;  // relative difference by which NLopt may be better
constexpr double kFree = std::numeric_limits<double>::infinity();

struct OuterCase {
  const char* name;
  FlattenInput input;
};
void PrintTo(const OuterCase& outer_case, std::ostream* out) { *out << outer_case.name; }

/// E(ψ(h)) as a function of the elastic parts' h, in the form that NLopt calls. The object remembers the smallest
/// value.
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

/// Returns the smallest E that an algorithm of NLopt finds within the bounds.
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

class KnownOptimizer : public testing::TestWithParam<OuterCase> {};

TEST_P(KnownOptimizer, FindsNothingBetter) {
  const Chart whole = test::chart_of(GetParam().input);
  const std::optional<Chart> refined = process_topology(whole);
  const Chart& chart = refined ? *refined : whole;
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

FlattenInput elastic_saddle() {
  const int n = 16;
  FlattenInput input = test::saddle(n, 0.3);
  for (const int line : {3, 7, 12}) {
    test::add_wire(input, test::grid_row(n, line), 0.03);
    test::add_wire(input, test::grid_column(n, n, line), 0.1);
  }
  return input;
}

FlattenInput elastic_gore() {
  const int gores = 6, n = 6;
  FlattenInput input = test::sphere_of_gores(gores, n, 16);
  for (const int ring : {3, 7, 11}) test::add_wire(input, test::tube_ring(gores * n, ring), 0.05);
  return input;
}

/// Returns a saddle with a closed wire that touches nothing. Helper wires connect it with the outline, and may have
/// any length.
FlattenInput elastic_ring() {
  const int n = 16;
  FlattenInput input = test::saddle(n, 0.3);
  test::add_wire(input, test::grid_square(n, 8, 8, 4), 0.05);
  return input;
}

INSTANTIATE_TEST_SUITE_P(OwnMeshes, KnownOptimizer,
                         testing::Values(OuterCase{"quarter_sphere_3_percent", elastic(test::quarter_sphere(16), 0.03)},
                                         OuterCase{"quarter_sphere_20_percent", elastic(test::quarter_sphere(16), 0.2)},
                                         OuterCase{"quarter_sphere_free", elastic(test::quarter_sphere(16), kFree)},
                                         OuterCase{"saddle", elastic_saddle()}, OuterCase{"gore", elastic_gore()},
                                         OuterCase{"ring", elastic_ring()}),
                         [](const testing::TestParamInfo<OuterCase>& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace wirewarp::test_known_optimizer
