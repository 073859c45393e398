// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the crease between a limb and the body, in which the two sides of a loop are easiest to flatten.
//
//   u      potential: 0 at the limb's end of a band, 1 at the body's end
//   w_ij   conductance of the edge from vertex i to vertex j, low where the surface is concave along the edge
//
// Σ_j w_ij (u_i - u_j) = 0 inside the band. Most of u changes at the crease, so lines of equal u follow it. From O.
// K.-C. Au, Y. Zheng, M. Chen, P. Xu, C.-L. Tai, Mesh segmentation with concavity-aware fields, IEEE Transactions on
// Visualization and Computer Graphics 18, 2012; the conductances are ours.
#pragma once

#include <Eigen/Core>

#include "surface/mesh/half_edge_mesh.h"

namespace wirewarp {

/// Returns u for the band around a loop. distance: distance of each vertex from the tip of the limb. level: distance of
/// the loop. length: length of the loop. All are in scene units.
Eigen::VectorXd potential_across(const HalfEdgeMesh& mesh, const Eigen::VectorXd& distance, double level,
                                 double length);

}  // namespace wirewarp
