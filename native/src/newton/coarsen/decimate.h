// SPDX-License-Identifier: GPL-3.0-or-later
// Takes vertices out of the mesh of a chart until its edges are about as long as wanted.
//
// A vertex goes by collapsing one of its edges. Before that, the faces around it are laid into the plane as z^a does it
// (A. W. F. Lee, W. Sweldens, P. Schröder, L. Cowsar, D. Dobkin, MAPS: multiresolution adaptive parameterization of
// surfaces, SIGGRAPH 1998): distances from the vertex kept, its angles scaled to a full turn, or on a wire to half a
// turn on each side. There the new faces are checked, and the vertices removed before find their place in them. A
// vertex on a wire or boundary goes along it alone; where such lines meet, end or turn sharply it stays.
#pragma once

#include <vector>

#include "base/stop_token.h"
#include "surface/charts/chart.h"
#include "surface/network/wire_network.h"

namespace wirewarp {

/// Where a vertex of the fine mesh lies in the coarse one: the sum of weights · vertices.
struct CoarsePlace {
  int vertices[3];
  double weights[3];  // sum 1; a vertex that is still there: 1, 0, 0
};

struct DecimatedMesh {
  HalfEdgeMesh mesh;
  std::vector<int> fine_vertex;     // of each vertex of the mesh
  std::vector<int> coarse_vertex;   // of each vertex of the chart; -1: removed
  std::vector<CoarsePlace> places;  // of each vertex of the chart; not set for removed ones on wires
};

/// network: the lines along which wire vertices stay. edge_length: wanted, scene units; no new edge is longer than
/// twice that. Throws Stopped, asking before each round over all vertices.
DecimatedMesh decimate(const Chart& chart, const HeldNetwork& network, double edge_length, const StopToken& stop = {});

}  // namespace wirewarp
