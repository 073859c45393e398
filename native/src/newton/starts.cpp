// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/starts.h"

#include <utility>

#include "energy/free_boundary_arap.h"
#include "newton/coarse_start.h"
#include "newton/injective_shape.h"
#include "newton/unfold.h"
#include "warp/outer/choose_variation.h"
#include "warp/topology/process_topology.h"
#include "warp/topology/unjoined_wires.h"

namespace wirewarp {

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

std::optional<RefinementStart> wires_alone(StartProblem& problem) {
  const Chart& chart = problem.task.chart;
  const Options plain;  // those of Eq. (1) are not the refined method's
  const StopToken stop = problem.stop.in("start");
  stop.check();
  std::optional<Chart> split;
  try {
    split = process_topology(chart, stop);
  } catch (const UnjoinedWires&) {
    return std::nullopt;
  }
  const Chart& prepared = split ? *split : chart;
  const WireNetwork network = build_wire_network(prepared);
  stop.check();
  Warp warp(prepared, network, plain.node_weight, plain.inner, stop);
  WarpedShape shape = start_variation(prepared, warp, variation_bounds(prepared, plain)).shape;
  if (!shape.inner.is_feasible) return std::nullopt;
  shape.uv.conservativeResize(static_cast<Eigen::Index>(chart.mesh.n_vertices()), 2);
  return RefinementStart(std::move(shape.uv));
}

std::optional<RefinementStart> injective_shape(StartProblem& problem) {
  return reach_injectively(problem, Injectivity::local);
}

}  // namespace wirewarp
