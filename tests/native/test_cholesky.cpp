// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "base/factorization_failed.h"
#include "cholesky_problems.h"
#include "dense_algebra.h"
#include "numerics/cholesky/eliminate_fronts.h"
#include "numerics/cholesky/multifrontal_cholesky.h"
#include "numerics/cholesky/multifrontal_lu.h"
#include "numerics/cholesky/vertex_separator.h"

namespace wirewarp::test_cholesky {
namespace {

using test::random_normal;

MultifrontalCholesky analyze(const CholeskyProblem& problem, const FrontKernels& kernels = fastest_kernels()) {
  return MultifrontalCholesky(problem.lower, problem.tree(), problem.unknowns_per_vertex, false, kernels);
}

Eigen::MatrixXd solve(const CholeskyProblem& problem, const Eigen::MatrixXd& b, bool in_threads = false) {
  MultifrontalCholesky cholesky(problem.lower, problem.tree(), problem.unknowns_per_vertex, in_threads);
  if (!cholesky.factorize(problem.lower)) throw std::domain_error("not positive definite");
  Eigen::MatrixXd x = b;
  cholesky.solve_in_place(x);
  return x;
}

TEST(MultifrontalCholesky, SolvesAsEigenDoes) {
  for (const CholeskyProblem& problem : cholesky_problems()) {
    SCOPED_TRACE(problem.name + ", unknowns per vertex: " + std::to_string(problem.unknowns_per_vertex));
    const Eigen::MatrixXd b = random_normal(problem.lower.rows(), 7, 3);
    const Eigen::SimplicialLLT<SparseMatrix> eigen(problem.lower);
    ASSERT_EQ(eigen.info(), Eigen::Success);
    const Eigen::MatrixXd expected = eigen.solve(b);
    for (const FrontKernels* kernels : all_kernels()) {
      MultifrontalCholesky cholesky = analyze(problem, *kernels);
      ASSERT_TRUE(cholesky.factorize(problem.lower));
      Eigen::MatrixXd x = b;
      cholesky.solve_in_place(x);
      const double scale = problem.lower.norm() * x.norm();
      EXPECT_LT((problem.lower.selfadjointView<Eigen::Lower>() * x - b).norm(), 1e-14 * scale);
      EXPECT_LT((x - expected).norm(), 1e-9 * expected.norm());
    }
  }
}

TEST(MultifrontalCholesky, EmptyMatrix) {
  const SparseMatrix empty(0, 0);
  MultifrontalCholesky cholesky(empty, {}, 2);
  EXPECT_TRUE(cholesky.factorize(empty));
}

TEST(MultifrontalCholesky, ResultsDoNotDependOnThreads) {
  for (const CholeskyProblem& problem : cholesky_problems()) {
    SCOPED_TRACE(problem.name);
    const Eigen::MatrixXd b = random_normal(problem.lower.rows(), 3, 5);
    EXPECT_EQ(solve(problem, b, true), solve(problem, b, false));
  }
}

/// A − c eᵢeᵢᵀ is positive definite if and only if c < 1 / (A⁻¹)ᵢᵢ.
TEST(MultifrontalCholesky, FindsASingleNegativePivotWhereverItIs) {
  CholeskyProblem problem = mesh_problem(12, 2);
  const Eigen::Index size = problem.lower.rows();
  const Eigen::VectorXd inverse_diagonal =
      test::solve(test::symmetric(problem.lower), Eigen::MatrixXd::Identity(size, size)).diagonal();
  for (const FrontKernels* kernels : all_kernels()) {
    MultifrontalCholesky cholesky = analyze(problem, *kernels);
    for (Eigen::Index i = 0; i < size; ++i) {
      const double diagonal = problem.lower.coeff(i, i);
      problem.lower.coeffRef(i, i) = diagonal - (1 - 1e-7) / inverse_diagonal[i];
      EXPECT_TRUE(cholesky.factorize(problem.lower)) << i;
      problem.lower.coeffRef(i, i) = diagonal - (1 + 1e-7) / inverse_diagonal[i];
      EXPECT_FALSE(cholesky.factorize(problem.lower)) << i;
      problem.lower.coeffRef(i, i) = diagonal;
    }
  }
}

TEST(MultifrontalCholesky, RefusesSingularMatrices) {
  const DissectionTree tree{{{{0, 1}, -1}}};
  for (const auto& [a, b, c] : std::vector<std::array<double, 3>>{{1, -1, 1}, {4, 2, 1}, {0, 0, 1}, {1, 0, 0}}) {
    SparseMatrix lower(2, 2);
    const std::vector<Eigen::Triplet<double>> entries{{0, 0, a}, {1, 0, b}, {1, 1, c}};
    lower.setFromTriplets(entries.begin(), entries.end());
    EXPECT_FALSE(MultifrontalCholesky(lower, tree, 1).factorize(lower)) << a << " " << b << " " << c;
  }
}

TEST(MultifrontalCholesky, RefusesEntriesThatAreNotFinite) {
  CholeskyProblem problem = mesh_problem(12, 2);
  MultifrontalCholesky cholesky = analyze(problem);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), kInfinity, -kInfinity}) {
    for (Eigen::Index i = 0; i < problem.lower.nonZeros(); i += 7) {
      const double value = std::exchange(problem.lower.valuePtr()[i], bad);
      EXPECT_FALSE(cholesky.factorize(problem.lower)) << bad << " in entry " << i;
      problem.lower.valuePtr()[i] = value;
    }
  }
}

TEST(MultifrontalCholesky, SolvesOnlyWithAFactor) {
  const CholeskyProblem problem = mesh_problem(12, 2);
  MultifrontalCholesky cholesky = analyze(problem);
  Eigen::MatrixXd b = random_normal(problem.lower.rows(), 1, 2);
  EXPECT_THROW(cholesky.solve_in_place(b), std::logic_error);
  EXPECT_FALSE(cholesky.factorize(-problem.lower));
  EXPECT_THROW(cholesky.solve_in_place(b), std::logic_error);
  EXPECT_TRUE(cholesky.factorize(problem.lower));
  const Eigen::MatrixXd expected = solve(problem, b);
  cholesky.solve_in_place(b);
  EXPECT_EQ(b, expected);
}

/// Two chains of blocks. Each vertex is coupled with one vertex of the next block, so the matrix has few entries but
/// large fronts. The constructor sets the dissection tree, too.
struct Chains {
  static constexpr int block = 400, length = 24, number = 2;

  Chains() : lower(number * length * block, number * length * block) {
    std::vector<Eigen::Triplet<double>> entries;
    for (int node = 0; node < number * length; ++node) {
      const bool is_root = node % length == length - 1;
      tree.nodes.push_back({std::vector<int>(block), is_root ? -1 : node + 1});
      std::iota(tree.nodes.back().vertices.begin(), tree.nodes.back().vertices.end(), node * block);
      for (const int v : tree.nodes.back().vertices) {
        entries.emplace_back(v, v, 3);
        if (!is_root) entries.emplace_back(v + block, v, -1);
      }
    }
    lower.setFromTriplets(entries.begin(), entries.end());
  }

  SparseMatrix lower;
  DissectionTree tree;
};

TEST(MultifrontalCholesky, PollsTheTokenRegularly) {
  const Chains chains;
  const double m = Chains::block / kTile;  // number of tiles along a front's pivots, and also along its other rows
  const double work_of_a_chain = (Chains::length - 1) * (m * m * m / 6 + m * m * m / 2 + m * m * m / 2);
  for (const bool in_threads : {false, true}) {
    MultifrontalCholesky cholesky(chains.lower, chains.tree, 1, in_threads);
    int asked = 0, last = 1'000'000;
    const StopToken stop([&, caller = std::this_thread::get_id()](const char*) {
      EXPECT_EQ(std::this_thread::get_id(), caller);
      return ++asked < last;
    });
    EXPECT_TRUE(cholesky.factorize(chains.lower, stop));
    EXPECT_GE(asked, std::floor(work_of_a_chain / (kWorkPerQuestion + 2 * m * m * m)));
    EXPECT_GE(asked, 2);
    asked = 0;
    last = 1;
    EXPECT_FALSE(cholesky.factorize(chains.lower, stop));
    EXPECT_EQ(asked, 1);
    Eigen::MatrixXd b = Eigen::MatrixXd::Ones(chains.lower.rows(), 1);
    EXPECT_THROW(cholesky.solve_in_place(b), std::logic_error);
  }
}

TEST(MultifrontalCholesky, PartialSolvesEqualTheFullSolve) {
  const CholeskyProblem problem = mesh_problem(40, 2);
  MultifrontalCholesky cholesky = analyze(problem);
  ASSERT_TRUE(cholesky.factorize(problem.lower));
  std::vector<int> line, block;
  for (int i = 0; i < 40; ++i) line.push_back(40 * i + 7);
  for (int i = 0; i < 100; ++i) block.push_back(40 * (20 + i / 10) + 25 + i % 10);
  const Eigen::MatrixXd values = random_normal(80, 5, 1);
  Eigen::MatrixXd b = Eigen::MatrixXd::Zero(problem.lower.rows(), 5);
  for (int i = 0; i < 40; ++i) b.middleRows<2>(2 * line[i]) = values.middleRows<2>(2 * i);
  Eigen::MatrixXd expected = b;
  cholesky.solve_in_place(expected);

  const auto to_line = cholesky.fronts_reaching(line), to_block = cholesky.fronts_reaching(block);
  const auto off_block = cholesky.others(to_block);
  const auto num_visited = [](const FrontSet& fronts) {
    return fronts.subtrees[0].size() + fronts.subtrees[1].size() + fronts.ancestors.size();
  };
  EXPECT_EQ(num_visited(to_block) + num_visited(off_block), num_visited(cholesky.all()));
  EXPECT_LT(num_visited(to_block), num_visited(off_block) / 3);
  const auto expect_equal = [&](const Eigen::MatrixXd& x, const std::vector<int>& vertices) {
    for (int v : vertices) EXPECT_EQ(x.middleRows<2>(2 * v), expected.middleRows<2>(2 * v)) << v;
  };
  cholesky.substitute_forward(b, to_line);
  Eigen::MatrixXd on_line = b;
  cholesky.substitute_back(on_line, to_line);
  expect_equal(on_line, line);
  cholesky.substitute_back(b, to_block);
  expect_equal(b, block);
  cholesky.substitute_back(b, off_block);
  EXPECT_EQ(b, expected);
}

TEST(MultifrontalCholesky, RefusesMatricesAndTreesThatDoNotFit) {
  const CholeskyProblem problem = mesh_problem(5, 1);
  const SparseMatrix& lower = problem.lower;
  const auto with = [&](DissectionTree tree) { MultifrontalCholesky(lower, tree, 1); };
  EXPECT_NO_THROW(with(problem.tree()));
  DissectionTree missing = problem.tree(), twice = problem.tree(), apart = problem.tree(), beyond = problem.tree();
  missing.nodes[0].vertices.pop_back();
  EXPECT_THROW(with(missing), std::invalid_argument);
  twice.nodes[0].vertices.push_back(twice.nodes[1].vertices[0]);
  EXPECT_THROW(with(twice), std::invalid_argument);
  beyond.nodes[0].vertices[0] = 25;
  EXPECT_THROW(with(beyond), std::invalid_argument);
  ASSERT_EQ(apart.nodes.size(), 3u);
  apart.nodes[0].parent = -1;  // a root of its own, although it is coupled with the separator
  EXPECT_THROW(with(apart), std::invalid_argument);
  std::swap(apart.nodes[1].vertices, apart.nodes[2].vertices);
  apart.nodes[0].parent = 2;  // now one half contains the separator
  EXPECT_THROW(with(apart), std::invalid_argument);
  EXPECT_THROW(MultifrontalCholesky(lower, problem.tree(), 2), std::invalid_argument);

  MultifrontalCholesky cholesky(lower, problem.tree(), 1);
  EXPECT_THROW(static_cast<void>(cholesky.factorize(mesh_problem(6, 1).lower)), std::invalid_argument);
  ASSERT_TRUE(cholesky.factorize(lower));
  Eigen::MatrixXd b(24, 1);
  EXPECT_THROW(cholesky.solve_in_place(b), std::invalid_argument);
}

/// A row of n vertices separates the n by n square. A tenth more is allowed, because jitter makes the median line
/// irregular.
TEST(NestedDissection, SeparatorOfASquareIsAboutOneRow) {
  for (const int n : {20, 100}) {
    const DissectionTree tree = mesh_problem(n, 1).tree();
    EXPECT_EQ(tree.nodes.back().parent, -1);
    EXPECT_LE(static_cast<int>(tree.nodes.back().vertices.size()), n + n / 10) << n;
    const auto halves = std::count_if(tree.nodes.begin(), tree.nodes.end(), [&](const DissectionTree::Node& node) {
      return node.parent == static_cast<int>(tree.nodes.size()) - 1;
    });
    EXPECT_EQ(halves, 2);
  }
}

TEST(NestedDissection, CutsAcrossTheShortSide) {
  // A strip of 4 by 100 vertices along a diagonal. Lines of constant x or y do not cross the strip at right angles.
  GraphEdges edges;
  Positions2 positions(400, 2);
  for (int i = 0; i < 100; ++i) {
    for (int j = 0; j < 4; ++j) {
      positions.row(4 * i + j) << i - j, i + j;
      if (j < 3) edges.push_back({4 * i + j, 4 * i + j + 1});
      if (i < 99) edges.push_back({4 * i + j, 4 * i + j + 4});
    }
  }
  const DissectionTree tree = nested_dissection(graph_of(400, edges), positions);
  EXPECT_EQ(tree.nodes.back().vertices.size(), 4u);
}

TEST(NestedDissection, UnconnectedPartsShareNoSeparator) {
  // Two rows of vertices in the same place, without edges between the rows.
  GraphEdges edges;
  Positions2 positions(80, 2);
  for (int i = 0; i < 80; ++i) {
    positions.row(i) << i % 40, 0;
    if (i % 40 != 0) edges.push_back({i - 1, i});
  }
  const DissectionTree tree = nested_dissection(graph_of(80, edges), positions);
  int num_roots = 0;
  for (const DissectionTree::Node& node : tree.nodes) {
    if (node.parent != -1) continue;
    ++num_roots;
    EXPECT_EQ(node.vertices.size(), 1u);
  }
  EXPECT_EQ(num_roots, 2);
}

TEST(NestedDissection, EmptyGraph) { EXPECT_TRUE(nested_dissection({{0}, {}}, Positions2(0, 2)).nodes.empty()); }

using Matrix = MultifrontalLu::Matrix;

/// A row-diagonally-dominant M-matrix on a mesh, and the positions of the mesh's vertices. Only every tenth row is
/// strictly dominant.
struct LuProblem {
  explicit LuProblem(const CholeskyProblem& mesh, unsigned seed = 7) : positions(mesh.positions) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> weight(0.01, 1.0);
    const auto size = static_cast<int>(positions.rows());
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < size; ++i) entries.emplace_back(i, i, i % 10 == 0 ? weight(random) : 0);
    for (const auto& [a, b] : mesh.edges) {
      for (const auto& [row, column] : {std::pair(a, b), std::pair(b, a)}) {
        const double w = weight(random);
        entries.emplace_back(row, column, -w);
        entries.emplace_back(row, row, w);
      }
    }
    matrix.resize(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
  }

  Matrix matrix;
  Positions2 positions;
};

TEST(MultifrontalLu, SolvesWithTheMatrixAndItsTranspose) {
  for (const int n : {1, 2, 7, 60}) {
    const LuProblem problem(mesh_problem(n, 1));
    const Matrix& a = problem.matrix;
    const Positions2 b = test::random_normal(a.rows(), 2, 1);
    for (const FrontKernels* kernels : all_kernels()) {
      const MultifrontalLu lu(a, problem.positions, false, {}, *kernels);
      Positions2 x = b;
      lu.solve(x);
      EXPECT_LT((a * x - b).cwiseAbs().maxCoeff(), 1e-13 * (1 + x.cwiseAbs().maxCoeff())) << n;
      Positions2 y = b;
      lu.solve_transposed(y);
      EXPECT_LT((a.transpose() * y - b).cwiseAbs().maxCoeff(), 1e-13 * (1 + y.cwiseAbs().maxCoeff())) << n;
    }
  }
}

TEST(MultifrontalLu, ResultsDoNotDependOnThreads) {
  const LuProblem problem(mesh_problem(60, 1));
  const Positions2 b = test::random_normal(problem.matrix.rows(), 2, 3);
  Positions2 x = b, in_threads = b;
  MultifrontalLu(problem.matrix, problem.positions, false).solve(x);
  MultifrontalLu(problem.matrix, problem.positions, true).solve(in_threads);
  EXPECT_EQ(in_threads, x);
}

/// A − c eᵢeᵢᵀ is singular if c = 1 / (A⁻¹)ᵢᵢ, and an M-matrix if c is smaller.
TEST(MultifrontalLu, RefusesAPivotThatIsNotPositive) {
  LuProblem problem(mesh_problem(12, 1));
  const Eigen::Index size = problem.matrix.rows();
  const Eigen::MatrixXd inverse = test::solve(Eigen::MatrixXd(problem.matrix), Eigen::MatrixXd::Identity(size, size));
  for (Eigen::Index i = 0; i < size; ++i) {
    const double diagonal = problem.matrix.coeff(i, i);
    problem.matrix.coeffRef(i, i) = diagonal - (1 - 1e-7) / inverse(i, i);
    EXPECT_NO_THROW(MultifrontalLu(problem.matrix, problem.positions)) << i;
    problem.matrix.coeffRef(i, i) = diagonal - (1 + 1e-7) / inverse(i, i);
    EXPECT_THROW(MultifrontalLu(problem.matrix, problem.positions), FactorizationFailed) << i;
    problem.matrix.coeffRef(i, i) = diagonal;
  }
}

TEST(MultifrontalLu, RefusesAPatternThatIsNotSymmetric) {
  Eigen::Matrix2d a;
  a << 1, -0.5, 0, 1;
  EXPECT_THROW(MultifrontalLu(a.sparseView(), Positions2::Zero(2, 2)), std::invalid_argument);
  Eigen::Matrix3d b;
  b << 2, -1, 0, 0, 2, -1, -1, 0, 2;
  EXPECT_THROW(MultifrontalLu(b.sparseView(), Positions2::Zero(3, 2)), std::invalid_argument);
}

}  // namespace
}  // namespace wirewarp::test_cholesky
