// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "surface/mesh/half_edge_mesh.h"

namespace wirewarp {

/// Returns the directions of least, middle and largest spread of a surface, as columns. If spreads are equal, as in a
/// ball, the first face determines the directions. spread: Σ x xᵀ over points x relative to the center.
Eigen::Matrix3d principal_axes(const HalfEdgeMesh& mesh, Eigen::Matrix3d spread);

}  // namespace wirewarp
