// SPDX-License-Identifier: GPL-3.0-or-later
// Symmetric positive definite matrices on graphs, for the tests of src/cholesky.
#pragma once

#include <Eigen/SparseCore>
#include <array>
#include <string>
#include <vector>

#include "numerics/cholesky/nested_dissection.h"

namespace wirewarp {

using SparseMatrix = Eigen::SparseMatrix<double>;
using GraphEdges = std::vector<std::array<int, 2>>;

struct CholeskyProblem {
  std::string name;
  int unknowns_per_vertex;
  Positions2 positions;
  GraphEdges edges;
  SparseMatrix lower;

  Graph graph() const;
  DissectionTree tree() const { return nested_dissection(graph(), positions); }
};

/// Both directions of every edge.
Graph graph_of(int num_vertices, const GraphEdges& edges);

/// Σ B_eᵀ B_e over the edges with random B_e (k by 2k, entries within ±1), and 0.1 on the diagonal. Lower triangle.
SparseMatrix random_positive_definite(int num_vertices, const GraphEdges& edges, int k, unsigned seed);

/// A triangulated square of n by n jittered vertices, k unknowns each, with some long edges, as bending rows make them.
CholeskyProblem mesh_problem(int n, int k);

/// Meshes, random graphs, separate pieces, single vertices, positions that say nothing.
std::vector<CholeskyProblem> cholesky_problems();

}  // namespace wirewarp
