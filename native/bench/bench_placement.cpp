// SPDX-License-Identifier: GPL-3.0-or-later
// Measures the interior placement alone: its factorization, and one placement for other wire lengths.
#include <benchmark/benchmark.h>

#include "bench_sheet.h"
#include "peak_memory.h"
#include "warp/inner/interior_placement.h"

namespace wirewarp {
namespace {

void placement_factor(benchmark::State& state) {
  const BenchSheet sheet(state);
  reset_peak_memory();
  for (auto _ : state) benchmark::DoNotOptimize(InteriorPlacement(sheet.chart(), sheet.network));
  state.counters["peak_MB"] = peak_memory_mb();
}

void placement_solve(benchmark::State& state) {
  const BenchSheet sheet(state);
  const InteriorPlacement placement(sheet.chart(), sheet.network);
  Positions2 uv = sheet.input.vertices.leftCols<2>();
  for (auto _ : state) placement.place(uv);
}

void placement_sizes(benchmark::internal::Benchmark* placement) {
  placement->ArgNames({"triangles", "wires"})
      ->ArgsProduct({{10'000, 100'000, 1'000'000}, {0, 2, 8}})
      ->Unit(benchmark::kMillisecond);
}
BENCHMARK(placement_factor)->Apply(placement_sizes);
BENCHMARK(placement_solve)->Apply(placement_sizes);

}  // namespace
}  // namespace wirewarp
