// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "charts/chart.h"
#include "mesh/edge_table.h"

namespace wirewarp {

/// The charts of a checked input, numbered by their lowest face. A chart with a fault carries its error.
Charts cut_into_charts(const FlattenInput& input, const EdgeTable& edges);

}  // namespace wirewarp
