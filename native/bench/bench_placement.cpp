// SPDX-License-Identifier: GPL-3.0-or-later
// The interior placement alone: factoring once, then placing for one more set of wire lengths.
#include <benchmark/benchmark.h>

#include "bumpy_sheet.h"
#include "charts/cut_into_charts.h"
#include "inner/interior_placement.h"
#include "peak_memory.h"

namespace wirewarp {
namespace {

struct Sheet {
  explicit Sheet(const benchmark::State& state)
      : input(bumpy_sheet(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)))),
        charts(cut_into_charts(input, EdgeTable(input.faces, static_cast<int>(input.vertices.rows())))),
        network(build_wire_network(chart())) {}
  const Chart& chart() const { return charts.charts.at(0); }

  FlattenInput input;
  Charts charts;
  WireNetwork network;
};

void placement_factor(benchmark::State& state) {
  const Sheet sheet(state);
  reset_peak_memory();
  for (auto _ : state) benchmark::DoNotOptimize(InteriorPlacement(sheet.chart(), sheet.network));
  state.counters["peak_MB"] = peak_memory_mb();
}

void placement_solve(benchmark::State& state) {
  const Sheet sheet(state);
  const InteriorPlacement placement(sheet.chart(), sheet.network);
  Positions2 uv = sheet.input.vertices.leftCols<2>();
  for (auto _ : state) placement.place(uv);
}

void sizes(benchmark::internal::Benchmark* placement) {
  placement->ArgNames({"triangles", "wires"})
      ->ArgsProduct({{10'000, 100'000, 1'000'000}, {0, 2, 8}})
      ->Unit(benchmark::kMillisecond);
}
BENCHMARK(placement_factor)->Apply(sizes);
BENCHMARK(placement_solve)->Apply(sizes);

}  // namespace
}  // namespace wirewarp
