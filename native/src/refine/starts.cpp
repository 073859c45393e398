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

const Positions2& free_uv(StartProblem& problem) {
  if (!problem.free_shape) {
    problem.free_shape = free_boundary_arap(problem.task.chart, kFreeSteps, {}, problem.stop.in("start")).uv;
  }
  return *problem.free_shape;
}

}  // namespace

std::optional<RefinementStart> unfolded(StartProblem& problem) {
  std::optional<Positions2> uv = unfold(problem.task.chart);
  if (!uv) return std::nullopt;
  return RefinementStart(std::move(*uv));
}

std::optional<RefinementStart> coarse_shape(StartProblem& problem) {
  if (problem.task.chart.mesh.n_faces() < problem.large_chart) return std::nullopt;
  return start_from_coarse(problem.task, problem.budget, problem.stop);
}

std::optional<RefinementStart> free_shape(StartProblem& problem) { return RefinementStart(free_uv(problem)); }

std::optional<RefinementStart> projected_shape(StartProblem& problem) {
  if (!problem.budget.allows()) return std::nullopt;
  Positions2 uv = free_uv(problem);
  RefineBudget budget(problem.budget, kMaxProjectFactorizations);
  if (!project_to_lengths(problem.task, uv, budget, problem.stop.in("shape"))) return std::nullopt;
  return RefinementStart(std::move(uv));
}

std::optional<RefinementStart> injective_shape(StartProblem& problem) {
  return reach_injectively(problem.task, {problem.budget, problem.stop, Injectivity::local});
}

}  // namespace wirewarp
