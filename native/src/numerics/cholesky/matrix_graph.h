// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/SparseCore>

#include "numerics/cholesky/nested_dissection.h"

namespace wirewarp {

/// Returns which vertices a symmetric matrix couples. lower: the lower triangle, compressed, in full blocks: unknowns k
/// v to k v + k - 1 belong to vertex v, k = unknowns_per_vertex, and each column has all unknowns of a vertex or none.
Graph graph_of(const Eigen::SparseMatrix<double>& lower, int unknowns_per_vertex);

}  // namespace wirewarp
