// SPDX-License-Identifier: GPL-3.0-or-later
// The linear rows of Eq. (1): angle sums of each wire-patch, around each inner vertex and around each hole.
#pragma once

#include <Eigen/Core>

#include "surface/network/wire_network.h"

namespace wirewarp {

/// Returns the planar angles closest to the surface angles (least Σ w (θ − α)²) that satisfy
///   Σ θ = (n − 2) π over the n nodes of each wire-patch,
///   Σ θ = 2 π around each network vertex inside the chart,
///   Σ θ = (m + 2) π around each hole of m vertices.
/// weights: one per node. The result is in radians, one per node.
Eigen::VectorXd project_on_angle_sums(const WireNetwork& network, const Eigen::VectorXd& weights);

}  // namespace wirewarp
