// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the necks of a closed surface: short loops that separate ears, limbs, a head or a tail from the rest.
//
//   tip       a vertex that is farther from the rest of the surface, averaged over the area, than all vertices nearby
//   d, L, A   distance from a tip; length of the line at this distance; area of the surface within this distance
//
// Beyond a neck, the surface widens, so L increases. At a neck, L / √A is least, where A is the smaller of the areas on
// both sides. L / √A is 2.5 at the equator of a ball. Tips are found by their average distance, as in E. Zhang, K.
// Mischaikow, G. Turk, Feature-based surface parameterization and texture mapping, ACM Transactions on Graphics 24,
// 2005.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "base/stop_token.h"
#include "surface/mesh/half_edge_mesh.h"

namespace wirewarp {

/// A loop along which a function has one value. The function is the distance from a tip, or the potential of
/// crease_lines.h. It is smaller in the part at the tip.
struct Neck {
  Eigen::VectorXd distance;  // value of the function per vertex
  double level = 0;          // value of the function at the loop
};

/// Returns the necks, largest part first. No two of them cross: their parts are disjoint, or one contains the other.
/// mesh: closed and connected. image: mirror image of each vertex, or empty; with an image, the necks are symmetric.
/// Throws Stopped.
std::vector<Neck> find_necks(const HalfEdgeMesh& mesh, const std::vector<VertexHandle>& image, const StopToken& stop);

}  // namespace wirewarp
