// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "charts/chart.h"
#include "network/wire_network.h"
#include "wirewarp/types.h"

namespace wirewarp {

/// Moves uv to exact lengths by Newton steps that look at nothing else: each the least change in the metric of the
/// Laplacian, with whatever variations of the elastic parts it takes. Those matter where more lengths are held than a
/// flat shape has freedom. False where the steps do not get there, or leave the tolerances. network: of all wires but
/// super-elastic ones. go_on is asked before each factorization; false: stop with what there is.
bool project_to_lengths(const Chart& chart, const WireNetwork& network, double fairness, Positions2& uv,
                        const std::function<bool()>& go_on);

}  // namespace wirewarp
