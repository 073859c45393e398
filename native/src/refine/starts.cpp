// SPDX-License-Identifier: GPL-3.0-or-later
#include "refine/starts.h"

#include <utility>

#include "arap/free_boundary_arap.h"
#include "outer/choose_variation.h"
#include "refine/coarse_start.h"
#include "refine/injective_shape.h"
#include "refine/project_to_lengths.h"
#include "refine/relax_lengths.h"
#include "refine/unfold.h"
#include "topology/process_topology.h"

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

std::optional<RefinementStart> wires_alone(StartProblem& problem) {
  const Options plain;  // those of Eq. (1) are not the refined method's
  const StopToken stop = problem.stop.in("start");
  stop.check();
  const std::optional<Chart> split = process_topology(problem.task.chart, stop);
  const Chart& prepared = split ? *split : problem.task.chart;
  const WireNetwork network = build_wire_network(prepared);
  stop.check();
  Warp warp(prepared, network, plain.node_weight, plain.inner, stop);
  WarpedShape shape = start_variation(prepared, warp, variation_bounds(prepared, plain)).shape;
  problem.inner = std::move(shape.inner);
  if (!problem.inner.is_feasible) return std::nullopt;
  shape.uv.conservativeResize(static_cast<Eigen::Index>(problem.task.chart.mesh.n_vertices()), 2);
  return RefinementStart(std::move(shape.uv));
}

std::optional<RefinementStart> injective_shape(StartProblem& problem) {
  return reach_injectively(problem.task, {problem.budget, problem.stop, Injectivity::local});
}

std::optional<RefinementStart> relaxed_shape(StartProblem& problem) {
  if (!problem.budget.allows()) return std::nullopt;
  const StopToken stop = problem.stop.in("shape");
  problem.relaxed = relax_lengths(problem.task, free_uv(problem), problem.budget, stop);
  Positions2 uv = problem.relaxed->uv;
  RefineBudget budget(problem.budget, kMaxProjectFactorizations);
  if (!project_to_lengths(problem.task, uv, budget, stop)) return std::nullopt;
  return RefinementStart(std::move(uv));
}

}  // namespace wirewarp
