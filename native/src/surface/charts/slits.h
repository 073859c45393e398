// SPDX-License-Identifier: GPL-3.0-or-later
// Slits: seams that end inside a piece at all their ends, buttonholes for example. Both rims are the same edges.
#pragma once

#include <optional>
#include <vector>

#include "surface/charts/chart.h"

namespace wirewarp {

struct Slit {
  HalfEdgeChain rims;     // a boundary loop with the chart on its left, beginning at a half-edge that leaves a tip
  std::vector<int> mate;  // for each half-edge, the place of the other half-edge on the same edge of the surface
};

/// Returns a boundary loop as a slit; none if an edge has no other rim in the loop, or the rims never turn back.
std::optional<Slit> as_slit(const Chart& chart, const HalfEdgeChain& loop);

/// Returns the boundary loops except the outer one that are slits with both rims at their 3D lengths.
std::vector<Slit> find_slits(const Chart& chart);

/// A chart with its slits sewn.
struct SewnChart {
  Chart chart;
  std::vector<int> vertex;  // of the sewn chart, one per vertex of the open one
};

/// Makes each slit a rigid wire, the last ones but those that give on the boundary. The outer loop stays the outer one.
/// None where the sewn surface is no chart. Slits of one edge may not be left open: sew all of them.
std::optional<SewnChart> sew(const Chart& chart, const std::vector<Slit>& slits);

}  // namespace wirewarp
