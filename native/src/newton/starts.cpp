// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/starts.h"

#include <utility>

#include "newton/coarse_start.h"
#include "newton/injective_shape.h"
#include "newton/injective_start.h"
#include "newton/unfold.h"
#include "warp/outer/choose_variation.h"
#include "warp/topology/process_topology.h"
#include "warp/topology/unjoined_wires.h"

namespace wirewarp {
std::optional<Shape> flatten_wires_first(Problem& problem, const Control& control) {
  const Chart& chart = problem.chart();
  const Options plain;  // default options, because the user's options for Eq. (1) are not for the refined method
  const StopToken stop = control.stop.in("start");
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
  return Shape{std::move(shape.uv)};
}

const std::array<Start, 5> kStarts{{
    // If the chart is developable, the unfolded chart is usually the final shape.
    {"unfolded", [](Problem& problem, const Control& /*control*/) { return unfold(problem.chart()); }},
    // The shape of a coarser chart is 1 to 3 factorizations from the minimum.
    {"coarse", [](Problem& problem, const Control& control) { return start_from_coarse(problem, control); }, true},
    // On most pieces, one step from the free ARAP flattening reaches exact lengths.
    {"free", [](Problem& problem,
                const Control& control) { return std::optional(Shape{problem.free_map(control.stop.in("start"))}); }},
    {"wires", flatten_wires_first},
    // This start reaches a shape without flips, and flips no triangle on the way.
    {kInjectiveStart,
     [](Problem& problem, const Control& control) {
       return injective_start(problem, {nullptr, nullptr, Injectivity::local}, control);
     },
     false, Injectivity::local},
}};

}  // namespace wirewarp
