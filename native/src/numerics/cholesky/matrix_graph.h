// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/SparseCore>

#include "numerics/cholesky/nested_dissection.h"

namespace wirewarp {

/// Returns the graph of the vertices that a symmetric matrix couples.
///
/// lower: the lower triangle, compressed, with all entries between coupled vertices
/// unknowns_per_vertex: k; unknowns k v to k v + k - 1 belong to vertex v
Graph graph_of(const Eigen::SparseMatrix<double>& lower, int unknowns_per_vertex);

}  // namespace wirewarp
