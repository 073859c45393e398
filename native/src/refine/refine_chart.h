// SPDX-License-Identifier: GPL-3.0-or-later
// The refined method for one chart: where it starts.
#pragma once

#include "inner/inner_problem.h"
#include "progress_report.h"
#include "refine/refine_shape.h"
#include "refine/relax_lengths.h"
#include "tuning.h"
#include "wirewarp/options.h"

namespace wirewarp {

/// Factorizations for a shape that is a start and need not be a minimum.
inline constexpr int kStartFactorizations = 10;

/// All that the starts of refine_from_scratch take to exact lengths, or to the end of what they try: one step from the
/// free shape, the shape with elastic wires free, one step from there, one from the wires flattened alone.
inline constexpr int kExactLengthsFactorizations = 1 + kStartFactorizations + 1 + 1;

struct RefineResult {
  RefinedShape shape;   // factorizations: of all starts; not exact: no flat shape with these lengths was found, or the
                        // limits came first
  InnerSolution inner;  // of the wires alone, if that start was tried; not feasible where even they do not close
  RelaxedShape loose;   // of the last start, if no other has exact lengths
  bool was_stopped = false;
};

/// The first start is a free ARAP flattening, one step from exact lengths on most pieces. Where that step fails, the
/// second is the shape with all elastic wires free, if there are any: many of them may lie within their tolerances.
/// Then the wires are flattened alone: the angles of Eq. (1) on the network that process_topology prepares, the other
/// vertices by interior placement (paper II-A); that shape has exact lengths. Where even this does not exist, the last
/// start is the shape that breaks lengths at the least price: none, if it finds that they can be kept after all.
/// All starts together keep to options.max_factorizations, the search for the least price not counted.
/// held_network: of all wires but super-elastic ones. go_on: asked in the stages "start" and "shape". Throws
/// std::domain_error where a factorization breaks down or no topology serves the wires.
RefineResult refine_from_scratch(const Chart& chart, const WireNetwork& held_network, const Options& options,
                                 const GoOn& go_on);

/// What refine_from_scratch tries until lengths are exact, and no more: one step from each start. options'
/// max_factorizations does not count.
RefineResult reach_exact_lengths(const Chart& chart, Options options, const GoOn& go_on);

/// Unfolds a chart that is folded from a plane (refine/unfold.h): mostly nothing is left to do. Sews up slits first,
/// but where that is so (refine/open_slits.h). Flattens a chart of tuning.large_chart faces or more coarsely first, and
/// starts from that shape (refine/coarse_start.h): two or three factorizations from the end. Smaller charts, and those
/// that these starts do not serve, from scratch. Throws as that does.
RefineResult refine_chart(const Chart& chart, const Options& options, const GoOn& go_on, const Tuning& tuning = {});

}  // namespace wirewarp
