// SPDX-License-Identifier: GPL-3.0-or-later
// Before anything is solved: can the outline hold the piece at all?
#pragma once

#include <optional>

#include "charts/chart.h"

namespace wirewarp {

/// boundary_too_short, with the cut that mends it, if the chart could have far too small a part of its area when flat.
std::optional<FlattenError> find_short_outline(const Chart& chart);

}  // namespace wirewarp
