// SPDX-License-Identifier: GPL-3.0-or-later
// A coarse copy of a chart and its wires: the same problem with fewer vertices.
#pragma once

#include <functional>
#include <vector>

#include "newton/coarsen/decimate.h"
#include "newton/coarsen/wire_runs.h"

namespace wirewarp {

/// The position of a fine wire edge on a coarse wire edge.
struct CoarseWirePlace {
  int edge = -1;
  /// Fractions of the coarse edge's length at which the fine edge's halfedge_handle(edge, 0) begins and ends.
  double from = 0, to = 0;
};

struct CoarseChart {
  Chart chart;                               // without super-elastic wires and boundary chains
  HeldNetwork network;                       // lengths and surface angles from the runs
  std::vector<WireRun> runs;                 // per coarse wire edge, along its halfedge_handle(edge, 0)
  std::vector<CoarsePlace> places;           // per fine vertex
  std::vector<CoarseWirePlace> wire_places;  // per fine wire edge
};

/// Returns the edge length of equilateral triangles with the mesh's number of faces and area, in scene units.
double typical_edge_length(const HalfEdgeMesh& mesh);

/// Returns whether a chart can be coarsened. This is impossible with a slit of one edge: its two sides connect the same
/// vertices, but coarsening identifies an edge by its ends.
bool can_coarsen(const Chart& chart);

/// Coarsens a chart to edges of about the given length in scene units. Throws Stopped.
CoarseChart coarsen(const Chart& chart, const HeldNetwork& network, double edge_length, const StopToken& stop = {});

}  // namespace wirewarp
