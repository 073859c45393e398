// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "charts/chart.h"
#include "feasibility/cut_mask.h"
#include "internal_options.h"
#include "stop_token.h"

namespace wirewarp {

/// E of Eq. (4) of a chart cut along edges of it (none: as it is) by the refined method, scene units squared;
/// infinite where it does not lie flat so. Throws Stopped.
double energy_when_cut(const Chart& chart, const CutMask& cut, const InternalOptions& options, const StopToken& stop);

}  // namespace wirewarp
