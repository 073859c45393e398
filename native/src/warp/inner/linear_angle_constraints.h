// SPDX-License-Identifier: GPL-3.0-or-later
// The linear rows of Eq. (1): angle sums of each wire-patch, around each inner vertex and around each hole.
#pragma once

#include <Eigen/Core>

#include "surface/network/wire_network.h"

namespace wirewarp {

/// Returns one planar angle θ per node, in radians, with the least Σ w (θ − α)² and these sums:
///
/// - wire-patch of n nodes: (n − 2) π
/// - network vertex inside the chart: 2 π
/// - hole of m vertices: (m + 2) π
///
/// α: surface angles; w: weights.
Eigen::VectorXd project_on_angle_sums(const WireNetwork& network, const Eigen::VectorXd& weights);

}  // namespace wirewarp
