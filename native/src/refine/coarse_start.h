// SPDX-License-Identifier: GPL-3.0-or-later
// Coarse to fine: a large chart starts from the shape of a coarser one.
#pragma once

#include <functional>
#include <optional>

#include "refine/refine_shape.h"
#include "wirewarp/options.h"

namespace wirewarp {

/// Refines a chart with edges four times as long, or less where wires wiggle in shorter waves, and takes its shape and
/// forces over to this one. None where that is hardly coarser, has no exact lengths, or where go_on stops it. network:
/// of all wires but super-elastic ones. The coarse chart's factorizations are not counted anywhere.
std::optional<RefinementStart> start_from_coarse(const Chart& chart, const WireNetwork& network, const Options& options,
                                                 const std::function<bool()>& go_on);

}  // namespace wirewarp
