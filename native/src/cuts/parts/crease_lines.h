// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the crease between a limb and the body. Both are easiest to flatten if the loop between them follows the
// crease.
//
//   u      potential: 0 at the limb's end of a band around the loop, 1 at the body's end
//   w_ij   conductance of the edge from vertex i to vertex j, low where the surface is concave along the edge
//
// At each vertex i inside the band, Σ_j w_ij (u_i - u_j) = 0. u changes most at the crease, so lines of equal u follow
// the crease. The method is from O. K.-C. Au, Y. Zheng, M. Chen, P. Xu, C.-L. Tai, Mesh segmentation with
// concavity-aware fields, IEEE Transactions on Visualization and Computer Graphics 18, 2012. The conductances are
// WireWarp's own.
#pragma once

#include <Eigen/Core>

#include "surface/mesh/half_edge_mesh.h"

namespace wirewarp {

/// Returns the potential u of a crease at each vertex. Lengths are in scene units. Throws FactorizationFailed.
/// - distance: distance of each vertex from the limb's tip
/// - level: distance of the loop from the tip
/// - length: length of the loop
Eigen::VectorXd potential_across(const HalfEdgeMesh& mesh, const Eigen::VectorXd& distance, double level,
                                 double length);

}  // namespace wirewarp
