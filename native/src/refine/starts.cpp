// SPDX-License-Identifier: GPL-3.0-or-later
#include "refine/starts.h"

#include <utility>

#include "arap/free_boundary_arap.h"
#include "refine/coarse_start.h"
#include "refine/injective_shape.h"
#include "refine/project_to_lengths.h"
#include "refine/unfold.h"

namespace wirewarp {
namespace {

constexpr int kMaxStepsToStart = 10;  // nets that take more to exact lengths are better left to the injective start

}  // namespace

const Positions2& StartProblem::free_map() {
  if (!known_free_map) known_free_map = free_boundary_arap(task.chart, kFreeSteps, {}, stop.in("start")).uv;
  return *known_free_map;
}

std::optional<RefinementStart> unfolded(StartProblem& problem) {
  std::optional<Positions2> uv = unfold(problem.task.chart);
  if (!uv) return std::nullopt;
  return RefinementStart(std::move(*uv));
}

std::optional<RefinementStart> coarse_shape(StartProblem& problem) {
  if (problem.task.chart.mesh.n_faces() < problem.large_chart) return std::nullopt;
  return start_from_coarse(problem.task, problem.budget, problem.stop);
}

std::optional<RefinementStart> free_shape(StartProblem& problem) { return RefinementStart(problem.free_map()); }

std::optional<RefinementStart> projected_shape(StartProblem& problem) {
  if (!problem.budget.allows()) return std::nullopt;
  Positions2 uv = problem.free_map();
  RefineBudget budget(problem.budget, kMaxStepsToStart);
  if (!project_to_lengths(problem.task, uv, budget, problem.stop.in("shape"))) return std::nullopt;
  return RefinementStart(std::move(uv));
}

std::optional<RefinementStart> injective_shape(StartProblem& problem) {
  return reach_injectively(problem, Injectivity::local);
}

}  // namespace wirewarp
