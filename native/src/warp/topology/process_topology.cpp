// SPDX-License-Identifier: GPL-3.0-or-later
#include "warp/topology/process_topology.h"

#include <algorithm>

#include "base/work_meter.h"
#include "warp/topology/hinged_wires.h"
#include "warp/topology/separate_loops.h"
#include "warp/topology/unjoined_wires.h"

namespace wirewarp {
namespace {

bool is_sound(const WireNetwork& network) {
  const bool has_tail =
      std::any_of(network.nodes.begin(), network.nodes.end(), [](const WireNode& node) { return node.is_tail; });
  return !has_tail && find_separate_loops(network).empty();
}

}  // namespace

std::optional<Chart> process_topology(const Chart& chart, const StopToken& stop) {
  if (is_sound(build_wire_network(chart))) return std::nullopt;
  SplitChart split(chart);
  WorkMeter work(stop);
  extend_hinged_wires(split, work);
  join_separate_loops(split, work);
  restore_delaunay(split, work);
  if (!is_sound(build_wire_network(split.chart))) throw UnjoinedWires("A wire is hinged or a loop is separate.");
  return std::move(split.chart);
}

}  // namespace wirewarp
