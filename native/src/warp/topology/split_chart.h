// SPDX-License-Identifier: GPL-3.0-or-later
// A chart whose triangles are divided so that new wires become edges. The surface does not change: new vertices are on
// edges without wires. Edges of wires and boundaries are never split, so every chain of half-edges stays valid.
#pragma once

#include <vector>

#include "base/work_meter.h"
#include "surface/charts/chart.h"

namespace wirewarp {

/// Marks the edges and vertices of a chart that are on wires and boundaries.
class WireMask {
 public:
  WireMask() = default;  // no wires
  explicit WireMask(const Chart& chart);

  void add(const HalfEdgeMesh& mesh, HalfedgeHandle h);

  /// Returns whether an edge or vertex is marked. New edges and vertices are not marked.
  bool has(EdgeHandle e) const { return static_cast<std::size_t>(e.idx()) < edges_.size() && edges_[e.idx()] != 0; }
  bool has(VertexHandle v) const {
    return static_cast<std::size_t>(v.idx()) < vertices_.size() && vertices_[v.idx()] != 0;
  }

 private:
  std::vector<char> edges_;
  std::vector<char> vertices_;
};

struct SplitChart {
  explicit SplitChart(const Chart& input) : chart(input), wires(input) { chart.free_map.reset(); }

  Chart chart;  // vertices of the input keep their indices; new vertices have source_vertex -1
  WireMask wires;
};

/// Splits an edge without a wire at from + t (to - from), and its two triangles at the new vertex.
VertexHandle split_edge(SplitChart& split, HalfedgeHandle h, double t);

/// In the regions around the seeds, splits each edge that connects two wire vertices without being on a wire, at its
/// middle. Then a path without wires connects any two wire vertices of a region.
void make_room(SplitChart& split, const std::vector<VertexHandle>& seeds);

/// Appends a super-elastic wire. The half-edges must not be on a wire.
void add_helper_wire(SplitChart& split, HalfEdgeChain half_edges);

/// Flips edges until the mesh is Delaunay. Does not flip wires and edges of input faces.
void restore_delaunay(SplitChart& split, WorkMeter& work);

}  // namespace wirewarp
