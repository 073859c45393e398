// SPDX-License-Identifier: GPL-3.0-or-later
// Measures the free ARAP flattening from two starts: the embedding in a circle, as in the refined method, and the shape
// with rigid wires, as for h0 in WireWarping++. Also measures the embedding alone.
#include <benchmark/benchmark.h>

#include "bench_sheet.h"
#include "energy/free_boundary_arap.h"
#include "energy/tutte_embedding.h"
#include "warp/outer/warp.h"

namespace wirewarp {
namespace {

void circle_embedding(benchmark::State& state) {
  const BenchSheet sheet(state);
  for (auto _ : state) benchmark::DoNotOptimize(tutte_embedding(sheet.chart()));
}

void free_start(benchmark::State& state) {
  const BenchSheet sheet(state);
  int iterations = 0;
  for (auto _ : state) iterations = free_boundary_arap(sheet.chart(), 30).iterations;
  state.counters["iterations"] = iterations;
}

void free_start_from_rigid(benchmark::State& state) {
  const BenchSheet sheet(state);
  Warp warp(sheet.chart(), sheet.network, NodeWeight::length, Inner::minimum);
  const auto num_parts = static_cast<Eigen::Index>(sheet.chart().wire_parts.size());
  const Positions2 rigid = warp(Eigen::VectorXd::Zero(num_parts)).uv;
  int iterations = 0;
  for (auto _ : state) iterations = free_boundary_arap(sheet.chart(), 30, rigid).iterations;
  state.counters["iterations"] = iterations;
}

void start_sizes(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgNames({"triangles", "wires"})
      ->ArgsProduct({{10'000, 100'000, 1'000'000}, {8}})
      ->Unit(benchmark::kMillisecond);
}
BENCHMARK(circle_embedding)->Apply(start_sizes);
BENCHMARK(free_start)->Apply(start_sizes);
BENCHMARK(free_start_from_rigid)->Apply(start_sizes);

}  // namespace
}  // namespace wirewarp
