// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the level lines of a function on a mesh: along these lines, the function equals a given value, the level. The
// function has one value per vertex, and is linear in each triangle. A value equal to the level counts as above the
// level.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "surface/mesh/half_edge_mesh.h"
#include "warp/topology/surface_path.h"

namespace wirewarp {

/// Returns the lines along which `values` equals `level`: first the lines from outline to outline, then the closed
/// lines. A closed line ends with its first point.
std::vector<MeshPath> level_lines(const HalfEdgeMesh& mesh, const Eigen::VectorXd& values, double level);

/// Returns the total length of the lines that level_lines() returns, in scene units.
double level_length(const HalfEdgeMesh& mesh, const Eigen::VectorXd& values, double level);

}  // namespace wirewarp
