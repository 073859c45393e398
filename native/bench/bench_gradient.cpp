// SPDX-License-Identifier: GPL-3.0-or-later
// Measures one evaluation of the shape error E(ψ(h)), and its gradient with respect to h, for increasing numbers of
// wires. The sheet is almost flat, so Eq. (1) is solved in few steps. On a sheet with higher bumps, an evaluation takes
// longer, but a gradient does not.
#include <benchmark/benchmark.h>

#include <cmath>

#include "bench_sheet.h"
#include "warp/outer/warp.h"

namespace wirewarp {
namespace {

constexpr double kHeight = 0.01;
constexpr double kVariation = 1e-4;  // relative change of the lengths

/// A Warp after its first use, so that the measurements do not contain work that is done only once.
struct BenchWarp {
  explicit BenchWarp(const benchmark::State& state)
      : sheet(state, kHeight),
        warp(sheet.chart(), sheet.network, NodeWeight::length, Inner::minimum),
        variation(static_cast<Eigen::Index>(sheet.chart().wire_parts.size())) {
    for (Eigen::Index i = 0; i < variation.size(); ++i) {
      variation[i] = kVariation * std::sin(3 + 2 * static_cast<double>(i));
    }
    shape = warp(variation);
    factorizations_before = warp.inner_factorizations();
  }
  void report(benchmark::State& state) const {
    if (!shape.inner.is_minimum) state.SkipWithError("no minimum of Eq. (1)");
    state.counters["factorizations"] =
        benchmark::Counter(warp.inner_factorizations() - factorizations_before, benchmark::Counter::kAvgIterations);
  }

  BenchSheet sheet;
  Warp warp;
  Eigen::VectorXd variation;
  WarpedShape shape;
  int factorizations_before = 0;
};

void error_evaluation(benchmark::State& state) {
  BenchWarp bench(state);
  for (auto _ : state) benchmark::DoNotOptimize(bench.warp.shape_error(bench.warp(bench.variation)));
  bench.report(state);
}

void error_gradient(benchmark::State& state) {
  BenchWarp bench(state);
  for (auto _ : state) benchmark::DoNotOptimize(bench.warp.gradient(bench.shape));
  bench.report(state);
}

void numbers_of_wires(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgNames({"triangles", "wires"})
      ->ArgsProduct({{10'000}, {4, 8, 16, 32, 64}})
      ->ArgsProduct({{100'000}, {4, 8, 16, 32, 64, 128, 232}})
      ->Unit(benchmark::kMillisecond);
}
BENCHMARK(error_evaluation)->Apply(numbers_of_wires);
BENCHMARK(error_gradient)->Apply(numbers_of_wires);

}  // namespace
}  // namespace wirewarp
