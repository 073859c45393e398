// SPDX-License-Identifier: GPL-3.0-or-later
// A chart before and after topology processing, and what holds for every one.
#pragma once

#include "surface/charts/chart.h"

namespace wirewarp::test {

struct Processed {
  Chart chart;
  Chart refined;
  std::size_t num_helpers() const { return refined.wire_parts.size() - chart.wire_parts.size(); }
};

/// Processes the first chart and expects of it: the same surface and wires, sound helper wires, nothing left to fix.
Processed process(const FlattenInput& input);

/// Largest difference between an edge's length on the surface and in ψ of the 3D lengths, relative.
double stretch_of_flattening(const Chart& chart);

}  // namespace wirewarp::test
