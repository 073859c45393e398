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

/// Returns all fields of Metrics except cloth_energy. uv: one finite row per chart vertex, scene units, front faces
/// counter-clockwise. Throws Stopped.
Metrics measure_metrics(const Chart& chart, const WireNetwork& network, const Positions2& uv,
                        const StopToken& stop = {});

/// Returns Metrics::cloth_energy. flat: x along the weft, y along the warp.
double measure_cloth_energy(const Chart& chart, const Positions2& flat, const Cloth& cloth);

/// Returns a warning if the strain of the fabric exceeds the limits of the cloth, otherwise nullopt. For each
/// direction, ignores the most strained 1% of the area, because single slivers do not matter.
std::optional<std::string> warn_of_limits(const Chart& chart, const Metrics& metrics, const Cloth& cloth);

/// Returns the planar angle θ of a wire-node's sector, radians, on the branch nearest to its surface angle.
double planar_angle(const Chart& chart, const WireNetwork& network, const WireNode& node, const Positions2& uv);

}  // namespace wirewarp
