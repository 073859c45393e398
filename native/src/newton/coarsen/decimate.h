// SPDX-License-Identifier: GPL-3.0-or-later
// Removes vertices from the mesh of a chart until its edges have about a target length.
//
// To remove a vertex, one of its edges is collapsed. Before that, the faces around the vertex are laid into the plane
// by the map z^a (A. W. F. Lee, W. Sweldens, P. Schröder, L. Cowsar, D. Dobkin, MAPS: multiresolution adaptive
// parameterization of surfaces, SIGGRAPH 1998). The map keeps distances from the vertex. It scales the angles at the
// vertex to a full turn, or on a wire to half a turn on each side. In the plane, the new faces are checked, and
// previously removed vertices get their places in the new faces. A vertex on a wire or on the boundary moves only along
// that line. A vertex where such lines meet, end or turn sharply is not removed.
#pragma once

#include <vector>

#include "base/stop_token.h"
#include "surface/charts/chart.h"
#include "surface/network/wire_network.h"

namespace wirewarp {

/// The position of a fine vertex in the coarse mesh: the sum of weights · vertices.
struct CoarsePlace {
  int vertices[3];
  double weights[3];  // their sum is 1; for a vertex that was not removed: 1, 0, 0
};

struct DecimatedMesh {
  HalfEdgeMesh mesh;
  std::vector<int> fine_vertex;     // vertex of the chart, for each vertex of the mesh
  std::vector<int> coarse_vertex;   // vertex of the mesh, for each vertex of the chart; -1: removed
  std::vector<CoarsePlace> places;  // for each vertex of the chart; not set for removed vertices on wires
};

/// Returns the coarser mesh of a chart, in which wire vertices remain on their lines. edge_length: target in scene
/// units; new edges have at most twice this length. Throws Stopped.
DecimatedMesh decimate(const Chart& chart, const HeldNetwork& network, double edge_length, const StopToken& stop = {});

}  // namespace wirewarp
