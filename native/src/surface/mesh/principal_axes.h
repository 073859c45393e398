// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "surface/mesh/half_edge_mesh.h"

namespace wirewarp {

/// Returns the directions of least, middle and largest spread of a surface, as columns. spread: the sum of x xᵀ over
/// points x relative to the center. If several directions have equal spread, as in a ball or a cube, the first face
/// decides, so that the axes rotate with the surface.
Eigen::Matrix3d principal_axes(const HalfEdgeMesh& mesh, Eigen::Matrix3d spread);

}  // namespace wirewarp
