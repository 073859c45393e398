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

/// Fills `ring` with the neighbors of an interior vertex and their mean-value weights, which sum to 1, in the order of
/// the mesh's vertex circulator. With α_j the 3D angle at the center of the triangle after neighbor j, and l_j the
/// length of the edge to neighbor j,
///
///   w_j = (tan(α_{j-1}/2) + tan(α_j/2)) / l_j.
///
/// On a flat one-ring the center is exactly Σ w_j x_j. No triangle of the ring may have zero area.
void mean_value_weights(const HalfEdgeMesh& mesh, VertexHandle center, std::vector<WeightedVertex>& ring);

}  // namespace wirewarp
