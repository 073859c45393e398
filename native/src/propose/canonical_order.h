// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "charts/chart.h"

namespace wirewarp {

/// A chart whose vertices and faces are numbered by its shape alone: however the input is numbered, turned or mirrored,
/// what goes through them in their order does the same. Symmetric charts have several such numberings; one is taken.
/// Its sources are the chart's own vertices, faces and wire parts. Throws Stopped where go_on says no.
Chart in_canonical_order(const Chart& chart, const std::function<bool()>& go_on);

}  // namespace wirewarp
