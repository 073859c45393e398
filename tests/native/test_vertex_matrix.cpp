// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <random>

#include "energy/vertex_matrix.h"

namespace wirewarp::test_vertex_matrix {
namespace {

/// Some of all pairs, a few of them twice and either way round.
std::vector<VertexPair> random_pairs(int num_vertices, std::mt19937& random) {
  std::vector<VertexPair> pairs;
  for (int a = 0; a < num_vertices; ++a) {
    for (int b = 0; b < num_vertices; ++b) {
      if (a != b && random() % 4 == 0) pairs.push_back({a, b});
    }
  }
  return pairs;
}

Eigen::Matrix2d random_block(std::mt19937& random) {
  std::normal_distribution<double> normal;
  Eigen::Matrix2d block;
  for (double& x : block.reshaped()) x = normal(random);
  return block;
}

/// Both triangles.
Eigen::MatrixXd dense(const Eigen::SparseMatrix<double>& lower) {
  const Eigen::MatrixXd matrix(lower);
  return matrix.selfadjointView<Eigen::Lower>();
}

TEST(VertexMatrix, AddsBlocksWhereTheyBelong) {
  for (unsigned seed = 0; seed < 5; ++seed) {
    std::mt19937 random(seed);
    const int n = 7;
    const std::vector<VertexPair> pairs = random_pairs(n, random);
    VertexMatrix matrix(n, pairs);
    Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(2 * n, 2 * n);
    for (const auto& [a, b] : pairs) {
      const int row = std::max(a, b), column = std::min(a, b);
      const Eigen::Matrix2d m = random_block(random);
      matrix.add(matrix.block(row, column), m);
      expected.block<2, 2>(2 * row, 2 * column) += m;
      expected.block<2, 2>(2 * column, 2 * row) += m.transpose();
    }
    for (int v = 0; v < n; ++v) {
      const Eigen::Matrix2d m = random_block(random);
      matrix.add_diagonal(v, m + m.transpose());
      expected.block<2, 2>(2 * v, 2 * v) += m + m.transpose();
      EXPECT_EQ(matrix.largest_diagonal(v), std::max(expected(2 * v, 2 * v), expected(2 * v + 1, 2 * v + 1)));
    }
    EXPECT_EQ(dense(matrix.lower()), expected);
    EXPECT_EQ(Eigen::MatrixXd(matrix.lower()).triangularView<Eigen::StrictlyUpper>().toDenseMatrix().norm(), 0);

    const Eigen::ArrayXd kept = matrix.values();
    matrix.set_zero();
    EXPECT_EQ(matrix.lower().norm(), 0);
    matrix.set_values(kept);
    EXPECT_EQ(dense(matrix.lower()), expected);
  }
}

TEST(VertexMatrix, AVertexPairedWithItselfHasItsDiagonalBlockAlone) {
  const VertexMatrix matrix(3, {{0, 0}, {2, 0}, {1, 1}, {0, 0}});
  const VertexMatrix without(3, {{2, 0}});
  EXPECT_EQ(matrix.lower().nonZeros(), without.lower().nonZeros());
  // The block of a submatrix is copied column by column, which Eigen does only for rising rows.
  EXPECT_EQ(Eigen::SparseMatrix<double>(matrix.lower().topLeftCorner(4, 4)).nonZeros(), 6);
}

TEST(VertexMatrix, TheGraphHasEachCoupledPairOnceFromEitherSide) {
  std::mt19937 random(1);
  const int n = 9;
  const std::vector<VertexPair> pairs = random_pairs(n, random);
  const Graph graph = VertexMatrix(n, pairs).graph();
  ASSERT_EQ(graph.start.size(), static_cast<std::size_t>(n + 1));
  for (int a = 0; a < n; ++a) {
    std::vector<int> found(graph.neighbors.begin() + graph.start[a], graph.neighbors.begin() + graph.start[a + 1]);
    std::sort(found.begin(), found.end());
    std::vector<int> expected;
    for (int b = 0; b < n; ++b) {
      const auto is_pair = [&](const VertexPair& p) { return p == VertexPair{a, b} || p == VertexPair{b, a}; };
      if (std::any_of(pairs.begin(), pairs.end(), is_pair)) expected.push_back(b);
    }
    EXPECT_EQ(found, expected) << a;
  }
}

}  // namespace
}  // namespace wirewarp::test_vertex_matrix
