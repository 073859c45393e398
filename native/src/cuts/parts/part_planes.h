// SPDX-License-Identifier: GPL-3.0-or-later
// Finds planes that divide a part of a toy, for example between the front and back of a body, along the rim of an ear,
// or along a limb.
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

/// Returns the centroid of a surface.
Eigen::Vector3d centroid_of(const HalfEdgeMesh& mesh);

/// Returns planes through the middle of a part. If the part has one outline, the first planes contain the outline's
/// middle and the part's centroid. If it has two outlines, the first planes contain both middles. If it has more
/// outlines, like a body between its limbs, the first plane is the plane nearest to all middles. Planes perpendicular
/// to the principal axes follow. strained: the place with too much strain; parallel planes through this place follow.
/// mirror: the plane that mirrors the part onto itself, if there is one. It mirrors each returned plane onto itself,
/// too.
std::vector<Plane> planes_through(const Chart& part, const std::optional<Eigen::Vector3d>& strained,
                                  const std::optional<Plane>& mirror);

}  // namespace wirewarp
