// SPDX-License-Identifier: GPL-3.0-or-later
// Distortion of one flat piece (paper IV-A).
#pragma once

#include <optional>
#include <string>

#include "base/stop_token.h"
#include "surface/network/wire_network.h"
#include "wirewarp/cloth.h"
#include "wirewarp/result.h"

namespace wirewarp {

/// Everything in Metrics. uv: one finite row per chart vertex, scene units, front faces counter-clockwise. Throws
/// Stopped.
Metrics measure_metrics(const Chart& chart, const WireNetwork& network, const Positions2& uv,
                        const StopToken& stop = {});

/// Metrics::cloth_energy. flat: x along the weft, y along the warp.
double measure_cloth_energy(const Chart& chart, const Positions2& flat, const Cloth& cloth);

/// What the cloth would have to bear beyond its limits, a sentence; nothing where it bears all. Of the 99th percentile
/// of strain by area in each direction: single slivers say nothing about a piece.
std::optional<std::string> warn_of_limits(const Chart& chart, const Metrics& metrics, const Cloth& cloth);

/// The planar angle θ of a wire-node's sector, radians, on the branch nearest to its surface angle.
double planar_angle(const Chart& chart, const WireNetwork& network, const WireNode& node, const Positions2& uv);

}  // namespace wirewarp
