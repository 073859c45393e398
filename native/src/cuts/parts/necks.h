// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the necks of a closed surface: short loops that separate ears, limbs, a head or a tail from the rest.
//
//   tip   a vertex with a larger average distance from all points of the surface than all vertices nearby
//   L     length of the line at some distance from a tip
//   A     area of the smaller of the two parts that this line separates
//
// Beyond a neck, the surface widens, so L increases. At a neck, L / √A is less than at the distances nearby. At the
// equator of a ball, which is not a neck, L / √A is 2.5. Tips are found by their average distance, as in E. Zhang, K.
// Mischaikow, G. Turk, Feature-based surface parameterization and texture mapping, ACM Transactions on Graphics 24,
// 2005.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "base/stop_token.h"
#include "surface/mesh/half_edge_mesh.h"

namespace wirewarp {

/// A loop along which a function has one value. The function is the distance from a tip, or the potential of
/// crease_lines.h. The function has smaller values in the part at the tip.
struct Neck {
  Eigen::VectorXd distance;  // value of the function per vertex
  double level = 0;          // value of the function at the loop
};

/// Returns the necks of a closed and connected mesh, the neck of the largest part first. Necks do not cross. Throws
/// Stopped.
/// - image: mirror image of each vertex, for symmetric necks; or empty
std::vector<Neck> find_necks(const HalfEdgeMesh& mesh, const std::vector<VertexHandle>& image, const StopToken& stop);

}  // namespace wirewarp
