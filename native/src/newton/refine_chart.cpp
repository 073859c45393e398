// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/refine_chart.h"

#include <initializer_list>
#include <utility>

#include "base/attempt.h"
#include "newton/injective_shape.h"
#include "newton/open_slits.h"
#include "newton/starts.h"
#include "newton/unfold.h"

namespace wirewarp {
namespace {

constexpr Start kUnfolded{"unfolded", unfolded};
constexpr Start kCoarse{"coarse", coarse_shape};
constexpr Start kFree{"free", free_shape};
constexpr Start kWiresAlone{"wires", wires_alone};
constexpr Start kInjective{"injective", injective_shape, Injectivity::local};

/// In the order in which they are tried; native/README.md says how often each won.
constexpr std::initializer_list<Start> kStarts{kUnfolded, kCoarse, kFree, kWiresAlone, kInjective};

/// Returns the first exact shape.
RefineResult try_starts(StartProblem& problem) {
  RefineResult result;
  bool is_any_infeasible = false;
  for (const Start& start : kStarts) {
    const std::optional<RefinementStart> made = attempt([&] { return start.make(problem); });
    if (problem.stop.is_stopped()) break;
    if (!made) continue;
    result.shape = refine_shape(problem.task, *made, {problem.budget, problem.stop.in("shape"), start.injectivity});
    if (result.shape.is_exact()) {
      result.start = start.name;
      break;
    }
    is_any_infeasible = is_any_infeasible || result.shape.status == ShapeStatus::infeasible;
  }
  if (!result.shape.is_exact()) {
    result.shape.status = problem.stop.is_stopped() ? ShapeStatus::cancelled
                          : is_any_infeasible       ? ShapeStatus::infeasible
                                                    : ShapeStatus::singular;
  }
  result.factorizations = problem.budget.spent();
  result.ran_out = problem.budget.ran_out();
  return result;
}

/// The unfolded chart where it has no strain: its slits are shut. Else sewn up and opened. Not exact where neither
/// serves.
RefineResult refine_with_slits(StartProblem& problem, const std::vector<Slit>& slits) {
  RefineResult result;
  if (const std::optional<Positions2> flat = unfold(problem.task.chart)) {
    result.shape = evaluate_shape(problem.task, *flat);
    if (result.shape.is_converged()) result.start = kUnfolded.name;
    if (result.shape.is_converged()) return result;
  }
  const auto refine_sewn = [&](const RefineTask& sewn) {
    StartProblem closed{sewn, problem.budget, problem.stop, problem.large_chart};
    return try_starts(closed).shape;
  };
  result.shape = open_slits(problem.task, slits, refine_sewn, {problem.budget, problem.stop.in("shape")});
  result.start = result.shape.is_exact() ? "sewn" : "";
  return result;
}

/// Another shape if the piece is flipped or overlaps itself, and one is found.
RefineResult without_flips_and_overlaps(RefineResult result, StartProblem& problem) {
  const bool is_other = make_injective(problem, result.shape);
  if (is_other) result.start = kInjective.name;
  result.factorizations = problem.budget.spent();
  result.ran_out = problem.budget.ran_out();
  return result;
}

}  // namespace

RefineResult refine_chart(const Chart& chart, const InternalOptions& options, RefineBudget& budget,
                          const StopToken& stop) {
  const HeldNetwork network = build_held_network(chart);
  const Target target = options.cloth ? Target::rough : options.target;
  StartProblem problem{{chart, network, options.fairness, nullptr, target}, budget, stop, options.large_chart};
  RefineResult result;
  if (const std::vector<Slit> slits = find_slits(chart); !slits.empty()) result = refine_with_slits(problem, slits);
  if (!result.shape.is_exact()) result = try_starts(problem);
  if (options.mends_folds) return without_flips_and_overlaps(std::move(result), problem);
  result.factorizations = budget.spent();
  result.ran_out = budget.ran_out();
  return result;
}

RefineResult refine_chart(const Chart& chart, const InternalOptions& options, const StopToken& stop) {
  RefineBudget budget(options.max_factorizations);
  return refine_chart(chart, options, budget, stop);
}

RefineResult refine_from_scratch(const RefineTask& task, RefineBudget& budget, const StopToken& stop) {
  StartProblem problem{task, budget, stop};
  return without_flips_and_overlaps(try_starts(problem), problem);
}

}  // namespace wirewarp
