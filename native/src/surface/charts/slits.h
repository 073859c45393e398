// SPDX-License-Identifier: GPL-3.0-or-later
// Slits: seams with all their ends inside a piece, such as buttonholes. Both rims have the same edges.
#pragma once

#include <optional>
#include <vector>

#include "surface/charts/chart.h"

namespace wirewarp {

struct Slit {
  HalfEdgeChain rims;     // a boundary loop, the chart on its left, starting with a half-edge that leaves a tip
  std::vector<int> mate;  // for each half-edge, the index of the other half-edge on the same edge of the surface
};

/// Returns a boundary loop as a slit, or nothing if an edge has only one rim in the loop or the rims never turn back.
std::optional<Slit> as_slit(const Chart& chart, const HalfEdgeChain& loop);

/// Returns the boundary loops except the outer one that are slits with both rims at their 3D lengths.
std::vector<Slit> find_slits(const Chart& chart);

/// A chart with its slits closed.
struct SewnChart {
  Chart chart;
  std::vector<int> vertex;  // vertex of the sewn chart for each vertex of the open one
};

/// Makes each slit a rigid wire; these follow the other wire parts, before elastic parts of the boundary. The outer
/// loop remains the outer one. Returns nothing if the sewn surface is not a chart. Slits of one edge must all be sewn.
std::optional<SewnChart> sew(const Chart& chart, const std::vector<Slit>& slits);

}  // namespace wirewarp
