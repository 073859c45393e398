// SPDX-License-Identifier: GPL-3.0-or-later
// The free ARAP flattening that h0 is taken from, begun as in a whole run at the rigid shape.
#include <benchmark/benchmark.h>

#include "bench_sheet.h"
#include "outer/free_arap.h"
#include "outer/warp.h"

namespace wirewarp {
namespace {

void free_start(benchmark::State& state) {
  const BenchSheet sheet(state);
  Warp warp(sheet.chart(), sheet.network, NodeWeight::length, Inner::minimum);
  const auto num_parts = static_cast<Eigen::Index>(sheet.chart().wire_parts.size());
  const Positions2 rigid = warp(Eigen::VectorXd::Zero(num_parts)).uv;
  int iterations = 0;
  for (auto _ : state) iterations = flatten_freely(sheet.chart(), 30, rigid).iterations;
  state.counters["iterations"] = iterations;
}
BENCHMARK(free_start)
    ->ArgNames({"triangles", "wires"})
    ->ArgsProduct({{10'000, 100'000, 1'000'000}, {8}})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace wirewarp
