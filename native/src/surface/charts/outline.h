// SPDX-License-Identifier: GPL-3.0-or-later
// Chains of the outline: seam edges and borders of the surface, between junctions.
#pragma once

#include <vector>

#include "surface/charts/chart.h"
#include "surface/charts/surface_cut.h"

namespace wirewarp {

struct Outline {
  std::vector<char> is_on_outline;              // per input vertex
  std::vector<char> is_junction;                // per input vertex: a chain ends there
  std::vector<std::vector<VertexPair>> chains;  // edges in order
  std::vector<int> chain_of_edge;               // per input edge: index of its chain; -1: not on the outline
  std::vector<int> seam_of_chain;               // per chain: index of its seam; -1: the border of the surface
};

/// Returns the outline in chains. A chain ends where three or more outline edges meet, at the tip of a dart, and where
/// the charts or fans beside it change.
Outline trace_outline(const Triangles& faces, const EdgeTable& edges, const SurfaceCut& cut);

/// Splits the charts' boundary loops into their boundary_chains, and returns the seams with their sides.
std::vector<Seam> assign_boundary_chains(const EdgeTable& edges, const SurfaceCut& cut, const Outline& outline,
                                         std::vector<Chart>& charts);

}  // namespace wirewarp
