// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of the least distorted shape with exact lengths.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

#include "dense_algebra.h"
#include "energy/fair_shape_error.h"
#include "energy/free_boundary_arap.h"
#include "energy/length_constraints.h"
#include "energy/shape_error.h"
#include "energy/tutte_embedding.h"
#include "newton/minimize.h"
#include "newton/refine_chart.h"
#include "surface/mesh/geometry.h"
#include "test_meshes.h"
#include "warp/outer/choose_variation.h"
#include "warp/topology/process_topology.h"

namespace wirewarp::test_minimize {
namespace {

constexpr double kFree = std::numeric_limits<double>::infinity();
// Allowed relative difference of the objective f. Each run stops when the next step would gain less than 1e-9 of f.
constexpr double kSameMinimum = 1e-7;

struct Case {
  explicit Case(const FlattenInput& input) : chart(test::chart_of(input)) {}

  Solution refine(const Positions2& start, int max_factorizations = 100) const {
    Budget budget(max_factorizations);
    return minimize({chart, fairness}, {}, {start}, {budget});
  }
  Solution refine() const { return refine(free_boundary_arap(chart, 30).uv); }

  /// Returns the shape of the paper's method, with the best lengths or with the lengths on the surface.
  Positions2 warped(bool has_best_lengths) const {
    const Chart prepared = process_topology(chart).value_or(chart);
    const WireNetwork prepared_network = build_wire_network(prepared);
    Warp warp(prepared, prepared_network, NodeWeight::length, Inner::minimum);
    const WarpedShape shape = has_best_lengths
                                  ? choose_variation(prepared, warp, variation_bounds(prepared, Options{})).shape
                                  : warp(Eigen::VectorXd::Zero(prepared.wire_parts.size()));
    EXPECT_TRUE(shape.inner.is_feasible);
    return shape.uv.topRows(chart.mesh.n_vertices());
  }

  double value(const Positions2& uv) const {
    return FairShapeError(chart, network, fairness).value(uv) / surface_area(chart.mesh);
  }

  int flips(const Positions2& uv) const { return FairShapeError(chart, network, fairness).count_flips(uv); }

  /// Returns the largest relative error of a length, |l₂ - (1 + h) l| / l, with the shape's h.
  double length_error(const Shape& shape) const {
    const LengthConstraints constraints(chart, network);
    Eigen::VectorXd variation(constraints.num_elastic());
    for (std::size_t i = 0; i < constraints.elastic_of_part().size(); ++i) {
      const int elastic = constraints.elastic_of_part()[i];
      if (elastic >= 0) variation[elastic] = shape.variation[i];
    }
    return constraints.largest_error(constraints.residual(shape.uv, variation));
  }

  double shortest_edge() const {
    double shortest = kFree;
    for (const WireEdge& edge : network.edges) shortest = std::min(shortest, edge.length);
    return shortest;
  }

  Chart chart;
  HeldNetwork network = build_held_network(chart);
  double fairness = 0.1;
};

Positions2 jittered(const Positions2& uv, double size, unsigned seed) {
  return uv + size * test::random_normal(uv.rows(), 2, seed);
}

FlattenInput with_tolerance(FlattenInput input, double tolerance) {
  for (Wire& wire : input.wires) wire.tolerance = tolerance;
  return input;
}

FlattenInput dome_with_wires(double tolerance) {
  const int n = 12;
  FlattenInput input = test::height_field(n, test::lopsided_dome);
  test::add_net(input, n, {3, 6, 9}, tolerance);
  return input;
}

FlattenInput gore_with_wires(double tolerance) {
  const int gores = 6, n = 6;
  FlattenInput input = test::sphere_of_gores(gores, n, 16);
  for (const int ring : {3, 7, 11}) test::add_wire(input, test::tube_ring(gores * n, ring), tolerance);
  return input;
}

FlattenInput saddle_with_a_floating_ring(double tolerance) {
  const int n = 12;
  FlattenInput input = test::saddle(n, 0.3);
  test::add_wire(input, test::grid_square(n, 6, 6, 2), tolerance);
  return input;
}

std::vector<FlattenInput> own_panels(double tolerance) {
  return {dome_with_wires(tolerance), gore_with_wires(tolerance), saddle_with_a_floating_ring(tolerance)};
}

TEST(Minimize, EveryStartLeadsToTheSameMinimum) {
  for (const double tolerance : {0.0, 0.05}) {
    for (const FlattenInput& input : own_panels(tolerance)) {
      const Case panel(input);
      const double little = 0.002 * panel.shortest_edge();
      const Positions2 free = free_boundary_arap(panel.chart, 30).uv,
                       mirror = free * Eigen::Vector2d(-1, 1).asDiagonal();
      const Solution first = panel.refine(free);
      ASSERT_TRUE(first.is_exact() && first.is_converged());
      EXPECT_LE(first.factorizations, 8);
      EXPECT_EQ(panel.flips(first.shape.uv), 0);
      EXPECT_LT(panel.length_error(first.shape), 1e-12);
      EXPECT_NEAR(first.objective, panel.value(first.shape.uv), 1e-12 * first.objective);
      const std::pair<const char*, Positions2> starts[] = {
          {"the wires first", panel.warped(false)},
          {"flipped", free_boundary_arap(panel.chart, 30, mirror).uv},
          {"on a circle", free_boundary_arap(panel.chart, 30, tutte_embedding(panel.chart)).uv},
          {"jittered, then free", free_boundary_arap(panel.chart, 30, jittered(free, 200 * little, 1)).uv},
          {"near the minimum", jittered(first.shape.uv, little, 2)}};
      for (const auto& [name, start] : starts) {
        const Solution other = panel.refine(start);
        EXPECT_TRUE(other.is_exact() && other.is_converged()) << name;
        EXPECT_NEAR(other.objective, first.objective, kSameMinimum * first.objective) << name;
      }
    }
  }
}

TEST(Minimize, MoreToleranceNeverRaisesTheMinimum) {
  for (const auto& make : {dome_with_wires, gore_with_wires, saddle_with_a_floating_ring}) {
    std::optional<Solution> before;
    for (const double tolerance : {0.0, 0.01, 0.1, 0.5}) {
      const Case panel(make(tolerance));
      const Solution found = panel.refine();
      EXPECT_LE(found.shape.variation.cwiseAbs().maxCoeff(), tolerance + 1e-12);
      if (before) {
        EXPECT_LE(found.objective, before->objective * (1 + 1e-9)) << tolerance;
        const Solution from_before = panel.refine(before->shape.uv);
        EXPECT_LE(from_before.objective, before->objective * (1 + 1e-9)) << tolerance;
        EXPECT_NEAR(from_before.objective, found.objective, kSameMinimum * found.objective);
      }
      before = found;
    }
  }
}

TEST(Minimize, ANarrowToleranceIsUsedCompletelyAndAWideToleranceIsNot) {
  const Solution narrow = Case(dome_with_wires(0.001)).refine(), wide = Case(dome_with_wires(0.5)).refine();
  EXPECT_GT(narrow.shape.variation.cwiseAbs().minCoeff(), 0.001 - 1e-12);
  EXPECT_LT(wide.shape.variation.cwiseAbs().maxCoeff(), 0.4);
}

/// At a minimum, f has no slope towards other shapes with exact lengths, so small moves to such shapes do not lower f.
TEST(Minimize, NothingNearIsBetter) {
  for (const FlattenInput& input : {dome_with_wires(0), dome_with_wires(0.02), test::quarter_sphere(12)}) {
    const Case panel(input);
    const Solution least = refine_chart(panel.chart, Options{});
    ASSERT_TRUE(least.is_exact() && least.is_converged());
    for (unsigned seed = 0; seed < 10; ++seed) {
      // One factorization leads to exact lengths nearby. No budget remains to find the minimum again.
      const Solution near = panel.refine(jittered(least.shape.uv, 0.01 * panel.shortest_edge(), seed), 1);
      ASSERT_TRUE(near.is_exact());
      EXPECT_GE(near.objective, least.objective * (1 - 1e-9));
    }
  }
}

/// Returns the distances between points on the outline of the quarter sphere. The points do not depend on n. turn_s and
/// turn_t choose one of four orders that are equivalent by symmetry.
Eigen::MatrixXd outline_distances(const Chart& chart, const Positions2& uv, int n, bool turn_s, bool turn_t) {
  std::vector<int> row_of(chart.source_vertex.size());
  for (std::size_t v = 0; v < row_of.size(); ++v) row_of[chart.source_vertex[v]] = static_cast<int>(v);
  std::vector<int> points;
  for (int k = 0; k <= 8; ++k) {
    for (const auto& [s, t] : {std::pair(0, k), std::pair(8, k), std::pair(k, 0), std::pair(k, 8)}) {
      const int i = (turn_s ? 8 - s : s) * n / 8, j = (turn_t ? 8 - t : t) * n / 4;
      points.push_back(row_of[i + (n + 1) * j]);
    }
  }
  return Eigen::MatrixXd::NullaryExpr(points.size(), points.size(), [&](Eigen::Index a, Eigen::Index b) {
    return (uv.row(points[a]) - uv.row(points[b])).norm();
  });
}

TEST(Minimize, ConvergesWhenTheSurfaceIsRefined) {
  // A prototype that shares no code with this program computed the energies E, at fairness 0.1.
  Options options;
  options.fairness = 0.1;
  const std::pair<int, double> expected[] = {{16, 0.0737}, {32, 0.0746}, {64, 0.0753}};
  Eigen::MatrixXd before;
  double change = std::numeric_limits<double>::infinity();
  for (const auto& [n, energy] : expected) {
    const Case sphere(test::quarter_sphere(n));
    const Solution found = refine_chart(sphere.chart, options);
    const Shape& shape = found.shape;
    EXPECT_TRUE(found.is_converged());
    EXPECT_LE(found.factorizations, 16) << n;
    EXPECT_EQ(sphere.flips(shape.uv), 0);
    EXPECT_NEAR(ShapeError(sphere.chart).energy(shape.uv) / surface_area(sphere.chart.mesh), energy, 0.01 * energy);
    if (before.size() > 0) {
      double nearest = std::numeric_limits<double>::infinity();
      for (const bool turn_s : {false, true}) {
        for (const bool turn_t : {false, true}) {
          const Eigen::MatrixXd now = outline_distances(sphere.chart, shape.uv, n, turn_s, turn_t);
          nearest = std::min(nearest, (now - before).cwiseAbs().maxCoeff());
        }
      }
      EXPECT_LT(nearest, 0.7 * change) << n;
      change = nearest;
    }
    before = outline_distances(sphere.chart, shape.uv, n, false, false);
  }
  EXPECT_LT(change, 0.02);
}

TEST(Minimize, StopsAtAnyBudgetWithExactLengths) {
  for (const FlattenInput& input : {with_tolerance(test::quarter_sphere(12), 0), dome_with_wires(0.05)}) {
    const Case panel(input);
    const Options options;
    Problem problem(panel.chart, panel.fairness);
    Budget unlimited(options.max_factorizations);
    const Solution whole = refine_chart(problem, options, {unlimited});
    double before = std::numeric_limits<double>::infinity();
    for (int most = 1; most <= unlimited.spent(); ++most) {
      Budget budget(most);
      const Solution found = refine_chart(problem, options, {budget});
      EXPECT_LE(budget.spent(), most);
      ASSERT_TRUE(found.is_exact()) << most;
      EXPECT_LT(panel.length_error(found.shape), 1e-11);
      EXPECT_LE(found.objective, before * (1 + 1e-12)) << most;
      EXPECT_NEAR(found.objective, panel.value(found.shape.uv), 1e-9 * found.objective);
      EXPECT_EQ(found.is_converged(), most == unlimited.spent());
      before = found.objective;
    }
    EXPECT_EQ(before, whole.objective);
  }
}

TEST(Minimize, CanceledAtAnyMomentTheShapeIsExactOrReportedAsCanceled) {
  for (const FlattenInput& input : {test::quarter_sphere(12), dome_with_wires(0.05)}) {
    const Case panel(input);
    int questions = 0;
    const StopToken count([&](const char*) { return ++questions > 0; });
    const Solution whole = refine_chart(panel.chart, Options{}, count);
    for (int last = 1; last <= questions; ++last) {
      int asked = 0;
      const StopToken stop([&](const char*) { return ++asked < last; });
      const Solution stopped = refine_chart(panel.chart, Options{}, stop);
      if (stopped.is_exact()) {
        EXPECT_LT(panel.length_error(stopped.shape), 1e-11);
        EXPECT_GE(stopped.objective, whole.objective * (1 - kSameMinimum));
      } else {
        EXPECT_EQ(stopped.status, SolutionStatus::cancelled);
        EXPECT_LT(last, questions) << "exact by then";
      }
      EXPECT_TRUE(stop.is_stopped());
      EXPECT_EQ(asked, last) << "it asks no more after a refusal";
    }
  }
}

/// The shape of the paper's method has allowed lengths, too, so its f must not be lower.
TEST(Minimize, IsNeverAboveTheShapeOfThePapersMethod) {
  for (const double tolerance : {0.0, 0.05}) {
    std::vector<FlattenInput> inputs = own_panels(tolerance);
    inputs.push_back(with_tolerance(test::quarter_sphere(12), tolerance));
    for (const FlattenInput& input : inputs) {
      const Case panel(input);
      const Positions2 uv = panel.warped(true);
      const Solution refined = refine_chart(panel.chart, Options{});
      EXPECT_LT(refined.objective, panel.value(uv));
      const Solution from_there = panel.refine(uv);
      EXPECT_TRUE(from_there.is_exact());
      EXPECT_LT(from_there.objective, panel.value(uv));
    }
  }
}

}  // namespace
}  // namespace wirewarp::test_minimize
