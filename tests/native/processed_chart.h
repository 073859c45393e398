// SPDX-License-Identifier: GPL-3.0-or-later
// A chart before and after topology processing, and the checks that every processed chart must pass.
#pragma once

#include "surface/charts/chart.h"

namespace wirewarp::test {

struct Processed {
  Chart chart;
  Chart refined;
  std::size_t num_helpers() const { return refined.wire_parts.size() - chart.wire_parts.size(); }
};

/// Processes the first chart. Expects that surface and wires stay the same, that helper wires are valid, and that
/// processing the result again changes nothing.
Processed process(const FlattenInput& input);

/// Flattens the chart with all wires at their lengths on the surface. Returns the largest relative change of an edge's
/// length.
double stretch_of_flattening(const Chart& chart);

}  // namespace wirewarp::test
