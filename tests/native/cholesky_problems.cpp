// SPDX-License-Identifier: GPL-3.0-or-later
#include "cholesky_problems.h"

#include <algorithm>
#include <random>
#include <utility>

namespace wirewarp {
namespace {

Positions2 random_positions(int num_vertices, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  return Positions2::NullaryExpr(num_vertices, 2, [&] { return coordinate(random); });
}

CholeskyProblem problem(std::string name, int k, Positions2 positions, GraphEdges edges) {
  const int n = static_cast<int>(positions.rows());
  const SparseMatrix lower = random_positive_definite(n, edges, k, 17);
  return {std::move(name), k, std::move(positions), std::move(edges), lower};
}

GraphEdges random_edges(int num_vertices, int num_edges) {
  std::mt19937 random(5);
  std::uniform_int_distribution<int> vertex(0, num_vertices - 1);
  GraphEdges edges;
  while (static_cast<int>(edges.size()) < num_edges) {
    const int a = vertex(random), b = vertex(random);
    if (a != b) edges.push_back({std::min(a, b), std::max(a, b)});
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

GraphEdges complete(int num_vertices) {
  GraphEdges edges;
  for (int a = 0; a < num_vertices; ++a) {
    for (int b = a + 1; b < num_vertices; ++b) edges.push_back({a, b});
  }
  return edges;
}

}  // namespace

std::vector<const FrontKernels*> all_kernels() {
  std::vector<const FrontKernels*> kernels{&kPlainKernels};
  if (has_avx2()) kernels.push_back(&kAvx2Kernels);
  return kernels;
}

Graph graph_of(int num_vertices, const GraphEdges& edges) {
  std::vector<std::vector<int>> neighbors(num_vertices);
  for (const auto& [a, b] : edges) {
    neighbors[a].push_back(b);
    neighbors[b].push_back(a);
  }
  Graph graph{{0}, {}};
  for (const std::vector<int>& of_vertex : neighbors) {
    graph.neighbors.insert(graph.neighbors.end(), of_vertex.begin(), of_vertex.end());
    graph.start.push_back(static_cast<int>(graph.neighbors.size()));
  }
  return graph;
}

Graph CholeskyProblem::graph() const { return graph_of(static_cast<int>(positions.rows()), edges); }

SparseMatrix random_positive_definite(int num_vertices, const GraphEdges& edges, int k, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < k * num_vertices; ++i) entries.emplace_back(i, i, 0.1);
  for (const auto& edge : edges) {
    const Eigen::MatrixXd b = Eigen::MatrixXd::NullaryExpr(k, 2 * k, [&] { return number(random); });
    const Eigen::MatrixXd product = b.transpose() * b;
    for (int i = 0; i < 2 * k; ++i) {
      for (int j = 0; j < 2 * k; ++j) {
        const int row = k * edge[i < k ? 0 : 1] + i % k, column = k * edge[j < k ? 0 : 1] + j % k;
        if (row >= column) entries.emplace_back(row, column, product(i, j));
      }
    }
  }
  SparseMatrix lower(k * num_vertices, k * num_vertices);
  lower.setFromTriplets(entries.begin(), entries.end());
  return lower;
}

CholeskyProblem mesh_problem(int n, int k) {
  Positions2 positions = random_positions(n * n, 1) * 0.3;
  GraphEdges edges;
  const auto vertex = [n](int i, int j) { return j * n + i; };
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      positions.row(vertex(i, j)) += Eigen::RowVector2d(i, j);
      if (i + 1 < n) edges.push_back({vertex(i, j), vertex(i + 1, j)});
      if (j + 1 < n) edges.push_back({vertex(i, j), vertex(i, j + 1)});
      if (i + 1 < n && j + 1 < n) edges.push_back({vertex(i, j), vertex(i + 1, j + 1)});
      if (i + 2 < n && j % 5 == 0) edges.push_back({vertex(i, j), vertex(i + 2, j)});
    }
  }
  return problem("mesh", k, std::move(positions), std::move(edges));
}

std::vector<CholeskyProblem> cholesky_problems() {
  std::vector<CholeskyProblem> problems;
  for (int k : {1, 2, 3}) {
    problems.push_back(problem("one vertex", k, random_positions(1, 2), {}));
    problems.push_back(problem("two vertices", k, random_positions(2, 2), {{0, 1}}));
    problems.push_back(problem("separate vertices", k, random_positions(50, 2), {}));
    problems.push_back(problem("complete graph", k, random_positions(150, 2), complete(150)));
    problems.push_back(problem("disconnected random graph", k, random_positions(300, 3), random_edges(300, 250)));
    problems.push_back(problem("random graph", k, random_positions(300, 3), random_edges(300, 900)));
    problems.push_back(mesh_problem(30, k));
  }
  CholeskyProblem coincident = mesh_problem(20, 2);
  coincident.name = "mesh whose vertices coincide";
  coincident.positions.setZero();
  problems.push_back(std::move(coincident));
  CholeskyProblem apart = mesh_problem(20, 2);
  apart.name = "mesh with two uncoupled unknowns per vertex";
  apart.lower.prune([](int row, int column, double) { return row % 2 == column % 2; });
  apart.lower.diagonal().array() += 10;
  problems.push_back(std::move(apart));
  return problems;
}

}  // namespace wirewarp
