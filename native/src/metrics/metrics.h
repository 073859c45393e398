// SPDX-License-Identifier: GPL-3.0-or-later
// Distortion of one flat piece (paper IV-A).
#pragma once

#include "network/wire_network.h"
#include "stop_token.h"
#include "wirewarp/result.h"

namespace wirewarp {

/// Everything in Metrics. uv: one finite row per chart vertex, scene units, front faces counter-clockwise. Throws
/// Stopped.
Metrics measure_metrics(const Chart& chart, const WireNetwork& network, const Positions2& uv,
                        const StopToken& stop = {});

/// The planar angle θ of a wire-node's sector, radians, on the branch nearest to its surface angle.
double planar_angle(const Chart& chart, const WireNetwork& network, const WireNode& node, const Positions2& uv);

}  // namespace wirewarp
