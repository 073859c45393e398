// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "surface/mesh/half_edge_mesh.h"

namespace wirewarp {

/// One connected part of a mesh. A chart is one; charts that are refined together are several.
struct ConnectedPart {
  std::vector<int> vertices;  // ascending
  double area = 0;            // scene units squared
};

/// By their lowest vertex.
std::vector<ConnectedPart> find_connected_parts(const HalfEdgeMesh& mesh);

/// Per vertex, the area of the connected part that it lies on, scene units squared.
std::vector<double> area_at_vertices(const HalfEdgeMesh& mesh);

}  // namespace wirewarp
