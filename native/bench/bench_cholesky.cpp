// SPDX-License-Identifier: GPL-3.0-or-later
// Measures the sparse Cholesky factorization (dissection, analysis, factorization, substitution) and Eigen's
// SimplicialLLT on the same matrix. The matrix describes a sheet with a spring on each edge, and has two unknowns per
// vertex.
#include <benchmark/benchmark.h>

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <stdexcept>
#include <vector>

#include "bumpy_sheet.h"
#include "numerics/cholesky/multifrontal_cholesky.h"
#include "peak_memory.h"

namespace wirewarp {
namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;

struct Springs {
  explicit Springs(const benchmark::State& state) {
    const FlattenInput sheet = bumpy_sheet(static_cast<int>(state.range(0)), 0, 0);
    positions = sheet.vertices.leftCols<2>();
    std::vector<std::array<int, 2>> ends;
    for (Eigen::Index f = 0; f < sheet.faces.rows(); ++f) {
      for (int i = 0; i < 3; ++i) {
        const int a = sheet.faces(f, i), b = sheet.faces(f, (i + 1) % 3);
        ends.push_back({a, b});
        ends.push_back({b, a});
      }
    }
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    join(ends);
    add_springs(ends);
  }

  void join(const std::vector<std::array<int, 2>>& ends) {
    graph.start.assign(static_cast<std::size_t>(positions.rows()) + 1, 0);
    for (const auto& [a, b] : ends) {
      ++graph.start[static_cast<std::size_t>(a) + 1];
      graph.neighbors.push_back(b);
    }
    for (std::size_t v = 1; v < graph.start.size(); ++v) graph.start[v] += graph.start[v - 1];
  }

  /// Adds a spring for each edge, a third as stiff across the edge as along it, and 1e-4 to each diagonal entry.
  void add_springs(const std::vector<std::array<int, 2>>& ends) {
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < 2 * positions.rows(); ++i) entries.emplace_back(i, i, 1e-4);
    for (const auto& [a, b] : ends) {
      const Eigen::RowVector2d along = (positions.row(b) - positions.row(a)).normalized();
      for (int i = 0; i < 2; ++i) {
        for (int j = 0; j < 2; ++j) {
          const double stiffness = along[i] * along[j] + (i == j ? 0.5 : 0);
          if (i >= j) entries.emplace_back(2 * a + i, 2 * a + j, stiffness);
          if (a > b) entries.emplace_back(2 * a + i, 2 * b + j, -stiffness);
        }
      }
    }
    lower.resize(2 * positions.rows(), 2 * positions.rows());
    lower.setFromTriplets(entries.begin(), entries.end());
  }

  MultifrontalCholesky analyze(bool in_threads = false, const FrontKernels& kernels = fastest_kernels()) const {
    return MultifrontalCholesky(lower, nested_dissection(graph, positions), 2, in_threads, kernels);
  }

  Positions2 positions;
  Graph graph;
  SparseMatrix lower;
};

void factorize(benchmark::State& state, bool in_threads, const FrontKernels& kernels) {
  const Springs springs(state);
  reset_peak_memory();
  MultifrontalCholesky cholesky = springs.analyze(in_threads, kernels);
  bool stable = cholesky.factorize(springs.lower);  // not measured: also waits for the system to provide memory
  for (auto _ : state) stable = cholesky.factorize(springs.lower) && stable;
  if (!stable) throw std::domain_error("the springs are not stable");
  state.counters["peak_MB"] = peak_memory_mb();
}

void cholesky_factor(benchmark::State& state) { factorize(state, false, fastest_kernels()); }
void cholesky_factor_two_threads(benchmark::State& state) { factorize(state, true, fastest_kernels()); }
void cholesky_factor_plain(benchmark::State& state) { factorize(state, false, kPlainKernels); }

void cholesky_dissect(benchmark::State& state) {
  const Springs springs(state);
  for (auto _ : state) benchmark::DoNotOptimize(nested_dissection(springs.graph, springs.positions));
}

void cholesky_analyze(benchmark::State& state) {
  const Springs springs(state);
  const DissectionTree tree = nested_dissection(springs.graph, springs.positions);
  for (auto _ : state) MultifrontalCholesky(springs.lower, tree, 2);
}

void cholesky_solve(benchmark::State& state) {
  const Springs springs(state);
  MultifrontalCholesky cholesky = springs.analyze();
  if (!cholesky.factorize(springs.lower)) throw std::domain_error("the springs are not stable");
  Eigen::MatrixXd b = Eigen::MatrixXd::Ones(springs.lower.rows(), state.range(1));
  for (auto _ : state) cholesky.solve_in_place(b);
}

void eigen_llt_factor(benchmark::State& state) {
  const Springs springs(state);
  reset_peak_memory();
  Eigen::SimplicialLLT<SparseMatrix> cholesky;
  cholesky.analyzePattern(springs.lower);
  for (auto _ : state) cholesky.factorize(springs.lower);
  state.counters["peak_MB"] = peak_memory_mb();
}

void eigen_llt_solve(benchmark::State& state) {
  const Springs springs(state);
  const Eigen::SimplicialLLT<SparseMatrix> cholesky(springs.lower);
  Eigen::MatrixXd b = Eigen::MatrixXd::Ones(springs.lower.rows(), state.range(1));
  for (auto _ : state) b = cholesky.solve(b).eval();
}

constexpr const char* kTriangles = "triangles";

void sizes(benchmark::internal::Benchmark* cholesky) {
  cholesky->ArgName(kTriangles)->Arg(10'000)->Arg(100'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);
}
void columns(benchmark::internal::Benchmark* solve) {
  solve->ArgNames({kTriangles, "columns"})
      ->ArgsProduct({{10'000, 100'000, 1'000'000}, {1, 4}})
      ->Unit(benchmark::kMillisecond);
}
BENCHMARK(cholesky_dissect)->Apply(sizes);
BENCHMARK(cholesky_analyze)->Apply(sizes);
BENCHMARK(cholesky_factor)->Apply(sizes);
BENCHMARK(cholesky_factor_two_threads)->Apply(sizes)->UseRealTime();
BENCHMARK(cholesky_factor_plain)->Apply(sizes);
BENCHMARK(cholesky_solve)->Apply(columns);

// Eigen's factorization would need more than a minute for a million triangles.
void smaller_sizes(benchmark::internal::Benchmark* cholesky) {
  cholesky->ArgName(kTriangles)->Arg(10'000)->Arg(100'000)->Unit(benchmark::kMillisecond);
}
void smaller_columns(benchmark::internal::Benchmark* solve) {
  solve->ArgNames({kTriangles, "columns"})->ArgsProduct({{10'000, 100'000}, {1, 4}})->Unit(benchmark::kMillisecond);
}
BENCHMARK(eigen_llt_factor)->Apply(smaller_sizes);
BENCHMARK(eigen_llt_solve)->Apply(smaller_columns);

}  // namespace
}  // namespace wirewarp
