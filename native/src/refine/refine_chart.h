// SPDX-License-Identifier: GPL-3.0-or-later
// The refined method for one chart: where it starts.
#pragma once

#include <functional>

#include "inner/inner_problem.h"
#include "refine/loose_lengths.h"
#include "refine/refine_shape.h"
#include "wirewarp/options.h"

namespace wirewarp {

struct ChartRefinement {
  RefinedShape shape;   // not exact: no flat shape with these lengths was found, or the limits came first
  InnerSolution inner;  // of the wires alone; not feasible where even they do not close
  LooseShape loose;     // of the last start, if no other has exact lengths
  bool was_stopped = false;
};

/// The first start is a free ARAP flattening, one step from exact lengths on most pieces. Where that step fails, the
/// second is the shape with all elastic wires free, if there are any: many of them may lie within their tolerances.
/// Then the wires are flattened alone: the angles of Eq. (1) on the network that process_topology prepares, the other
/// vertices by interior placement (paper II-A); that shape has exact lengths. Where even this does not exist, the last
/// start is the shape that breaks lengths at the least price: none, if it finds that they can be kept after all.
/// held_network: of all wires but super-elastic ones.
ChartRefinement refine_from_scratch(const Chart& chart, const WireNetwork& held_network, const Options& options,
                                    const std::function<bool()>& go_on);

/// Flattens a chart of 20,000 faces or more coarsely first, and starts from that shape (refine/coarse_start.h): two or
/// three factorizations from the end. Smaller charts, and those that the coarse shape does not serve, from scratch.
ChartRefinement refine_chart(const Chart& chart, const Options& options, const std::function<bool()>& go_on);

}  // namespace wirewarp
