// SPDX-License-Identifier: GPL-3.0-or-later
// A chart whose triangles are being cut so that new wires become edges. The surface does not change: new vertices lie
// on edges between wires, and edges of wires and boundaries are never cut, so every chain of half-edges stays valid.
#pragma once

#include <vector>

#include "base/work_meter.h"
#include "surface/charts/chart.h"

namespace wirewarp {

/// Where the wires and boundaries of a chart run.
class WireMask {
 public:
  WireMask() = default;  // no wires
  explicit WireMask(const Chart& chart);

  void add(const HalfEdgeMesh& mesh, HalfedgeHandle h);

  /// New edges and vertices carry no wire.
  bool has(EdgeHandle e) const { return static_cast<std::size_t>(e.idx()) < edges_.size() && edges_[e.idx()] != 0; }
  bool has(VertexHandle v) const {
    return static_cast<std::size_t>(v.idx()) < vertices_.size() && vertices_[v.idx()] != 0;
  }

 private:
  std::vector<char> edges_;
  std::vector<char> vertices_;
};

struct SplitChart {
  explicit SplitChart(const Chart& input) : chart(input), wires(input) {}

  Chart chart;  // the input's vertices keep their indices; new ones have source_vertex -1
  WireMask wires;
};

/// Cuts an edge that carries no wire at from + t (to - from), and its two triangles at the new vertex.
VertexHandle split_edge(SplitChart& refined, HalfedgeHandle h, double t);

/// Cuts in half every edge that joins two wire vertices without being on a wire, in the regions around the seeds. Then
/// a path between wires leads from every wire vertex of a region to every other one.
void make_room(SplitChart& refined, const std::vector<VertexHandle>& seeds);

/// Appends a super-elastic wire. The half-edges carry no wire yet.
void add_helper_wire(SplitChart& refined, HalfEdgeChain half_edges);

/// Flips edges to Delaunay, those alone that lie inside one input face and carry no wire.
void restore_delaunay(SplitChart& refined, WorkMeter& work);

}  // namespace wirewarp
