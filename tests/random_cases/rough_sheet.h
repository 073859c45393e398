// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "random_stream.h"

namespace wirewarp::test {

/// A manifold part of a mesh; faces counter-clockwise seen from outside.
struct MeshPart {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<int, 3>> faces;
};

/// What scans and sculptures are made of: a Delaunay triangulation of a random domain with up to four holes, under a
/// rough height, with needles of up to 1 : 10,000. Adds to `description` what it is.
MeshPart rough_sheet(RandomStream& random, std::string& description);

}  // namespace wirewarp::test
