// SPDX-License-Identifier: GPL-3.0-or-later
#include "warp/outer/choose_variation.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

#include "energy/free_boundary_arap.h"
#include "numerics/optimize/active_set_bfgs.h"
#include "surface/network/length_variation.h"

namespace wirewarp {
namespace {

constexpr double kTolerance = 1e-6;     // largest predicted relative decrease of E that is not worth another step
constexpr double kIsometry = 1e-14;     // E of strains of 1e-7, as rounding causes in float32 meshes; less counts as 0
constexpr int kMaxEvaluations = 100;    // 6 to 25 are usual, for 4 to 232 wires
constexpr std::size_t kManyParts = 50;  // with more parts, BFGS learns their interaction too slowly: without the
                                        // Gauss-Newton Hessian, 60 wires take 20 evaluations instead of 9
constexpr double kShortest = -0.99;     // keeps 1 + h > 0, with room for the line search
constexpr double kLongest = 100;        // bound on h of free wires, because the box must be finite

OuterSolution measured(const Warp& warp, const Eigen::VectorXd& variation, WarpedShape shape) {
  OuterSolution solution;
  solution.variation = variation;
  solution.shape = std::move(shape);
  solution.inner_solves = solution.shape.inner.num_solves;
  if (solution.shape.inner.is_feasible) solution.shape_error = warp.shape_error(solution.shape);
  return solution;
}

OuterSolution evaluate(Warp& warp, const Eigen::VectorXd& variation) {
  return measured(warp, variation, warp(variation));
}

OuterSolution improve(Warp& warp, const VariationBounds& bounds, OuterSolution start) {
  if (!start.shape.inner.is_minimum) {  // E has no gradient with respect to h at this point
    start.converged = false;
    return start;
  }
  const std::vector<int> parts = bounds.elastic_parts();
  const Eigen::VectorXd first = start.variation;
  const int evaluations_before = start.evaluations;
  const int free_factorizations = start.free_factorizations;
  const std::optional<Eigen::MatrixXd> hessian =
      parts.size() < kManyParts ? std::nullopt : std::optional(warp.gauss_newton_hessian(start.shape, parts));
  bool is_first = true;
  OuterSolution best;
  best.shape_error = std::numeric_limits<double>::infinity();
  int inner_solves = hessian ? 1 : 0;
  const BoxFunction error_of = [&](const Eigen::VectorXd& elastic) -> std::optional<ValueAndGradient> {
    warp.stop().check();
    Eigen::VectorXd variation = first;
    variation(parts) = elastic;
    OuterSolution trial = std::exchange(is_first, false)
                              ? std::move(start)
                              : measured(warp, variation, warp.follow(best.shape, variation));
    inner_solves += trial.inner_solves;
    if (!trial.shape.inner.is_minimum) return std::nullopt;
    ValueAndGradient result{trial.shape_error, warp.gradient(trial.shape)(parts)};
    ++inner_solves;
    if (trial.shape_error < best.shape_error) best = std::move(trial);
    return result;
  };
  const BoxMinimum minimum = minimize_in_box(error_of, bounds.lower(parts), bounds.upper(parts), first(parts),
                                             kTolerance, kMaxEvaluations, hessian);
  best.iterations = minimum.iterations;
  best.evaluations = evaluations_before + minimum.evaluations;
  best.free_factorizations = free_factorizations;
  best.inner_solves = inner_solves;
  best.converged = minimum.converged;
  return best;
}

}  // namespace

std::vector<int> VariationBounds::elastic_parts() const {
  std::vector<int> parts;
  for (int i = 0; i < lower.size(); ++i) {
    if (lower[i] < upper[i]) parts.push_back(i);
  }
  return parts;
}

VariationBounds variation_bounds(const Chart& chart, const Options& options) {
  const auto num_parts = static_cast<Eigen::Index>(chart.wire_parts.size());
  VariationBounds bounds{Eigen::VectorXd::Zero(num_parts), Eigen::VectorXd::Zero(num_parts)};
  if (options.inner == Inner::least_norm) return bounds;
  for (int i = 0; i < num_parts; ++i) {
    const WirePart& part = chart.wire_parts[i];
    const bool is_helper = part.wire_index < 0;
    if (options.method == Method::wirewarping && !is_helper) continue;
    bounds.lower[i] = std::max(-solver_tolerance(part), kShortest);
    bounds.upper[i] = std::min(solver_tolerance(part), kLongest);
  }
  return bounds;
}

OuterSolution start_variation(const Chart& chart, Warp& warp, const VariationBounds& bounds) {
  OuterSolution rigid = evaluate(warp, Eigen::VectorXd::Zero(bounds.lower.size()));
  const bool has_rigid = rigid.shape.inner.is_feasible;
  if (bounds.elastic_parts().empty() || (has_rigid && rigid.shape_error < kIsometry)) return rigid;

  warp.stop().check();
  const std::optional<Positions2> layout = has_rigid ? std::optional(rigid.shape.uv) : std::nullopt;
  const FreeBoundaryArap free = free_boundary_arap(chart, kFreeSteps, layout, warp.stop());
  OuterSolution relaxed =
      evaluate(warp, length_variation(chart, free.uv).cwiseMax(bounds.lower).cwiseMin(bounds.upper));
  const int inner_solves = rigid.inner_solves + relaxed.inner_solves;
  const auto rank = [](const OuterSolution& s) {
    return std::tuple(!s.shape.inner.is_feasible, !s.shape.inner.is_minimum, s.shape_error);
  };
  OuterSolution start = std::move(rank(relaxed) <= rank(rigid) ? relaxed : rigid);
  start.evaluations = 1;  // the evaluation of the start that is not used
  start.inner_solves = inner_solves;
  start.free_factorizations = free.factorizations;
  return start;
}

OuterSolution choose_variation(const Chart& chart, Warp& warp, const VariationBounds& bounds) {
  warp.stop().check();
  OuterSolution start = start_variation(chart, warp, bounds);
  const bool can_improve =
      !bounds.elastic_parts().empty() && start.shape.inner.is_feasible && !(start.shape_error < kIsometry);
  return can_improve ? improve(warp, bounds, std::move(start)) : start;
}

}  // namespace wirewarp
