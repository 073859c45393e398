// SPDX-License-Identifier: GPL-3.0-or-later
// Lines on a mesh along which a function has one value. Functions have one value per vertex and are linear in each
// triangle; a value at the level counts as above it.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "surface/mesh/half_edge_mesh.h"
#include "warp/topology/surface_path.h"

namespace wirewarp {

/// Returns the lines: first those from outline to outline, then closed ones, which repeat their first point.
std::vector<MeshPath> level_lines(const HalfEdgeMesh& mesh, const Eigen::VectorXd& values, double level);

/// Returns the length of all these lines, scene units.
double level_length(const HalfEdgeMesh& mesh, const Eigen::VectorXd& values, double level);

}  // namespace wirewarp
