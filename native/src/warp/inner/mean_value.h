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

/// Fills `ring` with the neighbors of an interior vertex, in circulator order, and their mean-value weights, with sum
/// 1. No triangle of the ring may have zero area.
void mean_value_weights(const HalfEdgeMesh& mesh, VertexHandle center, std::vector<WeightedVertex>& ring);

}  // namespace wirewarp
