// SPDX-License-Identifier: GPL-3.0-or-later
// Coarse to fine: a large chart starts from the shape of a coarser one.
#pragma once

#include <optional>

#include "newton/refine_shape.h"

namespace wirewarp {

/// Refines a chart with edges four times as long, or less where wires wiggle in shorter waves, and takes its shape and
/// forces over to this one. None where that is hardly coarser or has no exact lengths. stop: asked in the stage
/// "start". Throws Stopped, and FactorizationFailed.
std::optional<RefinementStart> start_from_coarse(const RefineTask& task, RefineBudget& budget,
                                                 const StopToken& stop = {});

}  // namespace wirewarp
