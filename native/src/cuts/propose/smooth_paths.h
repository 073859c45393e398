// SPDX-License-Identifier: GPL-3.0-or-later
// Finds paths along edges. The paths are short and smooth, and meet the outline squarely if possible.
//
// The cost of an edge is its length. A turn by τ radians makes the adjacent halves of both edges 1 + τ² times as
// expensive. Therefore, a zigzag costs a multiple of its length on every mesh. A smooth curve costs less on finer
// meshes, because its turns are smaller there. Turns are measured relative to the full angle around the vertex. So a
// straight path over the tip of a cone has the same angle on both sides.
#pragma once

#include <vector>

#include "surface/charts/chart.h"

namespace wirewarp {

struct Forbidden {
  std::vector<char> vertices;  // per vertex of the chart; for example, vertices on wires are forbidden
  std::vector<char> edges;     // per edge of the chart
};

struct SmoothPaths {
  std::vector<double> cost;             // per half-edge: cost of the path that ends with it; infinite: no path
  std::vector<HalfedgeHandle> before;   // per half-edge: the previous half-edge; invalid at the start
  std::vector<HalfedgeHandle> arrival;  // per vertex: last half-edge of the cheapest path; invalid: no path
};

class SmoothPathFinder {
 public:
  SmoothPathFinder(const Chart& chart, Forbidden forbidden);

  /// Returns the cheapest paths from a vertex to all others. The paths touch the outline only at their ends, squarely
  /// if possible.
  SmoothPaths paths_from(VertexHandle start) const;

  /// Returns the path from the start of `paths` to a vertex. Returns an empty chain if there is no path, or if the
  /// cheapest path passes a vertex twice.
  HalfEdgeChain path_to(const SmoothPaths& paths, VertexHandle end) const;

  /// Returns √area of the chart, in scene units.
  double size() const { return size_; }

  bool is_forbidden(VertexHandle v) const { return forbidden_.vertices[v.idx()] != 0; }
  bool is_forbidden(EdgeHandle e) const { return forbidden_.edges[e.idx()] != 0; }

 private:
  double landing_cost(HalfedgeHandle leaving) const;
  double turn(HalfedgeHandle in, HalfedgeHandle out) const;

  const HalfEdgeMesh& mesh_;
  double size_;
  Forbidden forbidden_;
  std::vector<double> direction_;  // per half-edge: angle around the vertex that it leaves
  std::vector<double> full_turn_;  // per vertex: the sum of its angles
};

}  // namespace wirewarp
