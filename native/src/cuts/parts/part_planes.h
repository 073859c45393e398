// SPDX-License-Identifier: GPL-3.0-or-later
// Finds planes that divide a part of a toy, for example a body into front and back, or a limb along its length.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "surface/charts/chart.h"

namespace wirewarp {

struct Plane {
  Eigen::Vector3d point, normal;  // point in scene units; normal of length 1

  Plane mirrored(const Plane& mirror) const;
};

/// Returns the signed distance of each vertex from a plane, in scene units.
Eigen::VectorXd distances_from(const Plane& plane, const HalfEdgeMesh& mesh);

/// Returns the plane that mirrors a mesh onto itself. image: mirror image of each vertex; not empty.
Plane mirror_plane(const HalfEdgeMesh& mesh, const std::vector<VertexHandle>& image);

Eigen::Vector3d centroid_of(const HalfEdgeMesh& mesh);

/// Returns planes that may divide a part, in this order:
/// - through the middles of its outlines, or near them
/// - through its centroid, perpendicular to its principal axes
/// - parallel to these planes, through the strained place, if there is one
///
/// If `mirror` mirrors the part onto itself, it mirrors each returned plane, too.
std::vector<Plane> planes_through(const Chart& part, const std::optional<Eigen::Vector3d>& strained,
                                  const std::optional<Plane>& mirror);

}  // namespace wirewarp
