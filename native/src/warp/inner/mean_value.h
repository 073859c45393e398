// SPDX-License-Identifier: GPL-3.0-or-later
// Mean-value weights: M. S. Floater, Mean value coordinates, Computer Aided Geometric Design 20 (2003), 19-27.
#pragma once

#include <vector>

#include "surface/mesh/half_edge_mesh.h"

namespace wirewarp {

struct WeightedVertex {
  VertexHandle vertex;
  double weight;  // positive
};

/// Fills `ring` with the neighbors of an interior vertex, in the order of the mesh's vertex circulator, and with their
/// mean-value weights. In the triangle after neighbor j, α_j is the 3D angle at the vertex `center`. l_j is the length
/// of the edge to neighbor j. The weights are
///
///   w_j = (tan(α_{j-1}/2) + tan(α_j/2)) / l_j,
///
/// divided by their sum. If the one-ring is flat, the weighted mean of the neighbors is exactly the center. No triangle
/// of the ring may have zero area.
void mean_value_weights(const HalfEdgeMesh& mesh, VertexHandle center, std::vector<WeightedVertex>& ring);

}  // namespace wirewarp
