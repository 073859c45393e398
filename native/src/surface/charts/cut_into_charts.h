// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/stop_token.h"
#include "surface/charts/chart.h"
#include "surface/mesh/edge_table.h"

namespace wirewarp {

/// Returns the charts of a checked input, in the order of their first faces. A chart with a fault contains its error.
/// Throws Stopped.
/// - fans: the fan of each corner on the uncut surface, needed if the input is only a part of this surface
Charts cut_into_charts(const FlattenInput& input, const EdgeTable& edges, const StopToken& stop = {},
                       const std::vector<int>& fans = {});

/// Returns all charts without their meshes. Each chart contains only its faces and `error`.
Charts list_charts(const FlattenInput& input, const EdgeTable& edges, const FlattenError& error);

}  // namespace wirewarp
