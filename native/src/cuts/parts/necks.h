// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the necks of a closed surface: short loops that separate ears, limbs, a head or a tail from the rest.
//
//   tip       a vertex that is farther from the rest of the surface, on average over the area, than all others around
//   d, L, A   distance from a tip; length of the line at this distance; area of the surface within it
//
// Beyond a neck, the surface widens, so L increases. At a neck, L / √A is least, with A the smaller of the areas on
// both sides; it would be 2.5 at the equator of a ball. The average distance as a sign of tips is from E. Zhang, K.
// Mischaikow, G. Turk, Feature-based surface parameterization and texture mapping, ACM Transactions on Graphics 24,
// 2005.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "base/stop_token.h"
#include "surface/mesh/half_edge_mesh.h"

namespace wirewarp {

/// A loop where a function has one value: the distance from a tip, or the potential of crease_lines.h. The part at the
/// tip is where the function is less.
struct Neck {
  Eigen::VectorXd distance;  // per vertex
  double level = 0;          // the value at the loop
};

/// Returns the necks, those around larger parts first. No two of them cross: their parts are disjoint, or one contains
/// the other. mesh: closed and connected. image: mirror image of each vertex, or empty; with an image, the necks are
/// symmetric. Throws Stopped.
std::vector<Neck> find_necks(const HalfEdgeMesh& mesh, const std::vector<VertexHandle>& image, const StopToken& stop);

}  // namespace wirewarp
