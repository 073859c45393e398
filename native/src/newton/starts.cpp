// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/starts.h"

#include <stdexcept>
#include <utility>

#include "newton/coarse_start.h"
#include "newton/injective_shape.h"
#include "newton/unfold.h"
#include "warp/outer/choose_variation.h"
#include "warp/topology/process_topology.h"
#include "warp/topology/unjoined_wires.h"

namespace wirewarp {
namespace {

std::optional<Shape> wires_alone(Problem& problem, const Control& control) {
  const Chart& chart = problem.chart();
  const Options plain;  // options of Eq. (1), which the refined method does not use
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

}  // namespace

const char* name_of(Start start) {
  switch (start) {
    case Start::unfolded:
      return "unfolded";
    case Start::coarse:
      return "coarse";
    case Start::free:
      return "free";
    case Start::wires:
      return "wires";
    case Start::injective:
      return kInjectiveStart;
  }
  throw std::logic_error("not a Start");
}

std::optional<Shape> make_start(Start start, Problem& problem, const Control& control) {
  switch (start) {
    case Start::unfolded: {
      std::optional<Positions2> uv = unfold(problem.chart());
      return uv ? std::optional(Shape{std::move(*uv)}) : std::nullopt;
    }
    case Start::coarse:
      return start_from_coarse(problem, control);
    case Start::free:
      return Shape{problem.free_map(control.stop.in("start"))};
    case Start::wires:
      return wires_alone(problem, control);
    case Start::injective:
      return reach_injectively(problem, {nullptr, nullptr, Injectivity::local}, control);
  }
  throw std::logic_error("not a Start");
}

}  // namespace wirewarp
