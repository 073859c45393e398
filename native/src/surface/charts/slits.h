// SPDX-License-Identifier: GPL-3.0-or-later
// Slits: seams with all their ends inside a piece, such as buttonholes. Both rims have the same edges.
#pragma once

#include <optional>
#include <vector>

#include "surface/charts/chart.h"

namespace wirewarp {

struct Slit {
  HalfEdgeChain rims;     // a boundary loop with the chart on its left; the first half-edge leaves a tip
  std::vector<int> mate;  // for each half-edge, the index of the other half-edge on the same edge of the surface
};

/// Returns a boundary loop as a slit; nullopt if the loop contains only one rim of an edge, or if the rims never turn
/// back.
std::optional<Slit> as_slit(const Chart& chart, const HalfEdgeChain& loop);

/// Returns the slits among the inner boundary loops. Slits whose rims have an ease or a tolerance are left out.
std::vector<Slit> find_slits(const Chart& chart);

struct SewnChart {
  Chart chart;
  std::vector<int> vertex;  // vertex of the sewn chart for each vertex of the open chart
};

/// Returns the half-edge of the sewn chart for a half-edge of the open chart; not valid if there is none.
HalfedgeHandle sewn_half_edge(const Chart& chart, const SewnChart& sewn, HalfedgeHandle h);

/// Sews slits. Their edges become rigid wires, listed before the elastic parts of the boundary. Returns nullopt if the
/// sewn surface is not a chart, or if rims that stay open become one edge.
std::optional<SewnChart> sew(const Chart& chart, const std::vector<Slit>& slits);

}  // namespace wirewarp
