// SPDX-License-Identifier: GPL-3.0-or-later
// Planes along which a part of a toy is divided: front and back of a body, the rim of an ear, the length of a limb.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "surface/charts/chart.h"

namespace wirewarp {

struct Plane {
  Eigen::Vector3d point, normal;  // scene units; of length 1

  Plane mirrored(const Plane& mirror) const;
};

/// Returns the signed distance of each vertex from a plane, scene units.
Eigen::VectorXd distances_from(const Plane& plane, const HalfEdgeMesh& mesh);

/// Returns the plane that mirrors a mesh onto itself. image: mirror image of each vertex; not empty.
Plane mirror_plane(const HalfEdgeMesh& mesh, const std::vector<VertexHandle>& image);

/// Returns the centroid of a surface.
Eigen::Vector3d centroid_of(const HalfEdgeMesh& mesh);

/// Returns planes through the middle of a part: those along its principal axes; along a limb, those that contain the
/// middle of its outline; and the plane nearest to the middles of several outlines, for example of a body between its
/// limbs. strained: the place with too much strain; parallel planes through it follow. mirror: given if it mirrors the
/// part onto itself; then it mirrors each of the planes onto itself, too.
std::vector<Plane> planes_through(const Chart& part, const std::optional<Eigen::Vector3d>& strained,
                                  const std::optional<Plane>& mirror);

}  // namespace wirewarp
