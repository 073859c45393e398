// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <benchmark/benchmark.h>

#include "bumpy_sheet.h"
#include "surface/charts/cut_into_charts.h"
#include "surface/network/wire_network.h"

namespace wirewarp {

/// The bumpy sheet as a chart, with the numbers of triangles and wires from the first two arguments of a benchmark.
struct BenchSheet {
  explicit BenchSheet(const benchmark::State& state, double height = 0.3)
      : input(bumpy_sheet(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)), 0, height)),
        charts(cut_into_charts(input, EdgeTable(input.faces, static_cast<int>(input.vertices.rows())))),
        network(build_wire_network(chart())) {}
  const Chart& chart() const { return charts.charts.at(0); }

  FlattenInput input;
  Charts charts;
  WireNetwork network;
};

}  // namespace wirewarp
