// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "surface/mesh/half_edge_mesh.h"

namespace wirewarp {

/// One connected part of a mesh. A chart has one part; a combined chart of a coupled group has several.
struct ConnectedPart {
  std::vector<int> vertices;  // ascending
  double area = 0;            // scene units squared
};

/// Returns the parts, ordered by their lowest vertex.
std::vector<ConnectedPart> find_connected_parts(const HalfEdgeMesh& mesh);

/// Returns per vertex the area of its connected part, scene units squared.
std::vector<double> area_at_vertices(const HalfEdgeMesh& mesh);

}  // namespace wirewarp
