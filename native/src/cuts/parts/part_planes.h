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

/// Returns planes through the middle of a part. The first planes depend on the number of the part's outlines:
/// - For one outline, they contain the outline's middle and the part's centroid.
/// - For two outlines, they contain the middles of both outlines.
/// - For more outlines, as on a body between its limbs, there is one plane, nearest to all middles.
///
/// Planes perpendicular to the principal axes follow. strained: the place with too much strain. If it is set, planes
/// through this place follow, parallel to all planes before. mirror: the plane that mirrors the part onto itself. If it
/// is set, it mirrors each returned plane onto itself, too.
std::vector<Plane> planes_through(const Chart& part, const std::optional<Eigen::Vector3d>& strained,
                                  const std::optional<Plane>& mirror);

}  // namespace wirewarp
