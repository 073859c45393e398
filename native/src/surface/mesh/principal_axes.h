// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "surface/mesh/half_edge_mesh.h"

namespace wirewarp {

/// The directions in which a surface spreads least, more and most, as columns. spread: the sum of x xᵀ over points x
/// from the middle. Where a surface spreads alike in several directions, as a ball or a cube, its first face decides:
/// axes turn with the surface.
Eigen::Matrix3d principal_axes(const HalfEdgeMesh& mesh, Eigen::Matrix3d spread);

}  // namespace wirewarp
