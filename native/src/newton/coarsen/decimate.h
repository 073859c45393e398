// SPDX-License-Identifier: GPL-3.0-or-later
// Removes vertices from the mesh of a chart until its edges have about a target length.
//
// Collapsing one of its edges removes a vertex. Before that, the faces around it are laid into the plane by the map z^a
// (A. W. F. Lee, W. Sweldens, P. Schröder, L. Cowsar, D. Dobkin, MAPS: multiresolution adaptive parameterization of
// surfaces, SIGGRAPH 1998): it keeps distances from the vertex and scales its angles to a full turn, or on a wire to
// half a turn on each side. There the new faces are checked, and vertices removed before get their places in them. A
// vertex on a wire or boundary moves only along that line, and stays where such lines meet, end or turn sharply.
#pragma once

#include <vector>

#include "base/stop_token.h"
#include "surface/charts/chart.h"
#include "surface/network/wire_network.h"

namespace wirewarp {

/// The position of a fine vertex in the coarse mesh: the sum of weights · vertices.
struct CoarsePlace {
  int vertices[3];
  double weights[3];  // sum 1; for a vertex that was not removed: 1, 0, 0
};

struct DecimatedMesh {
  HalfEdgeMesh mesh;
  std::vector<int> fine_vertex;     // for each vertex of the mesh
  std::vector<int> coarse_vertex;   // for each vertex of the chart; -1: removed
  std::vector<CoarsePlace> places;  // for each vertex of the chart; not set for removed vertices on wires
};

/// network: the lines on which wire vertices stay. edge_length: the target, scene units; no new edge is longer than
/// twice that. Throws Stopped; the token is polled before each round over all vertices.
DecimatedMesh decimate(const Chart& chart, const HeldNetwork& network, double edge_length, const StopToken& stop = {});

}  // namespace wirewarp
