// SPDX-License-Identifier: GPL-3.0-or-later
// Makes symmetric positive definite matrices on graphs, for the tests of src/numerics/cholesky.
#pragma once

#include <Eigen/SparseCore>
#include <array>
#include <string>
#include <vector>

#include "numerics/cholesky/front_kernels.h"
#include "numerics/cholesky/nested_dissection.h"

namespace wirewarp {

using SparseMatrix = Eigen::SparseMatrix<double>;
using GraphEdges = std::vector<std::array<int, 2>>;

/// Returns the kernels that this processor can run.
std::vector<const FrontKernels*> all_kernels();

struct CholeskyProblem {
  std::string name;
  int unknowns_per_vertex;
  Positions2 positions;
  GraphEdges edges;
  SparseMatrix lower;

  Graph graph() const;
  DissectionTree tree() const { return nested_dissection(graph(), positions); }
};

Graph graph_of(int num_vertices, const GraphEdges& edges);

/// Returns the lower triangle of 0.1 I + Σ B_eᵀ B_e over the edges e. B_e: random k by 2k matrices with entries from -1
/// to 1.
SparseMatrix random_positive_definite(int num_vertices, const GraphEdges& edges, int k, unsigned seed);

/// Returns a triangulated square of n by n jittered vertices with k unknowns each. Some edges connect vertices two
/// columns apart, as the terms of bending do.
CholeskyProblem mesh_problem(int n, int k);

/// Returns matrices on meshes, on random, complete and disconnected graphs, and on isolated vertices. In one mesh, all
/// vertices have the same position. In another mesh, the two unknowns of a vertex are not coupled.
std::vector<CholeskyProblem> cholesky_problems();

}  // namespace wirewarp
