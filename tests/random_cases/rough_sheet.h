// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "random_stream.h"

namespace wirewarp::test {

/// A manifold part of a mesh, with faces counter-clockwise from outside.
struct MeshPart {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<int, 3>> faces;
};

/// Returns a mesh like a scan or a sculpture. It is a Delaunay triangulation of a random domain with up to four holes,
/// a rough height and needles of up to 1 : 10,000. Appends a word to the description.
MeshPart rough_sheet(RandomStream& random, std::string& description);

}  // namespace wirewarp::test
