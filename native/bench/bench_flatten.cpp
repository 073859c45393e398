// SPDX-License-Identifier: GPL-3.0-or-later
// Measures the time of each stage and the peak memory of whole runs: two methods; 10,000, 100,000 and 1,000,000
// triangles; 2 rigid, 8 rigid or 8 elastic wires.
#include <benchmark/benchmark.h>

#include <map>
#include <string>

#include "bumpy_sheet.h"
#include "peak_memory.h"

namespace wirewarp {
namespace {

void flatten_sheet(benchmark::State& state, Method method) {
  const FlattenInput input = bumpy_sheet(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)),
                                         static_cast<double>(state.range(2)) / 100);
  Options options;
  options.method = method;
  reset_peak_memory();
  std::map<std::string, double> seconds;
  for (auto _ : state) {
    const FlattenResult result = flatten(input, options);
    if (result.pieces.at(0).error) state.SkipWithError(result.pieces.at(0).error->what());
    for (const auto& [stage, time] : result.seconds) seconds[stage] += time;
  }
  for (const auto& [stage, time] : seconds) {
    state.counters[stage + "_ms"] = benchmark::Counter(1e3 * time, benchmark::Counter::kAvgIterations);
  }
  state.counters["peak_MB"] = peak_memory_mb();
}

void refine_sheet(benchmark::State& state) { flatten_sheet(state, Method::refined); }
void warp_sheet(benchmark::State& state) { flatten_sheet(state, Method::wirewarp_plus_plus); }

void sizes_and_wires(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgNames({"triangles", "wires", "percent"})
      ->ArgsProduct({{10'000, 100'000, 1'000'000}, {2, 8}, {0}})
      ->ArgsProduct({{10'000, 100'000, 1'000'000}, {8}, {3}})
      ->Unit(benchmark::kMillisecond);
}
BENCHMARK(refine_sheet)->Apply(sizes_and_wires);
BENCHMARK(warp_sheet)->Apply(sizes_and_wires);

}  // namespace
}  // namespace wirewarp

BENCHMARK_MAIN();
