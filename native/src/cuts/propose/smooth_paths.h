// SPDX-License-Identifier: GPL-3.0-or-later
// Paths along edges that are short, run on smoothly, and land on the outline squarely.
//
// A turn by τ makes the edges beside it (1 + τ²) times as long. So a zigzag costs what it is long, however fine the
// mesh, and a curve costs less the finer it is. Turns are shares of the angle around the vertex: on a cone straight on
// is where both sides have the same angle.
#pragma once

#include <vector>

#include "surface/charts/chart.h"

namespace wirewarp {

/// Where no path may run.
struct Forbidden {
  std::vector<char> vertices;  // per vertex of the chart; such as those on wires
  std::vector<char> edges;     // per edge of the chart
};

/// The cheapest paths from one vertex.
struct SmoothPaths {
  std::vector<double> cost;             // per half-edge: of the path that ends with it; infinite where none does
  std::vector<HalfedgeHandle> before;   // per half-edge: the one before it; not valid at the start
  std::vector<HalfedgeHandle> arrival;  // per vertex: where the cheapest path arrives; not valid where none does
};

class SmoothPathFinder {
 public:
  SmoothPathFinder(const Chart& chart, Forbidden forbidden);

  /// Paths that meet the outline at their ends alone, squarely where there is a choice.
  SmoothPaths paths_from(VertexHandle start) const;

  /// From the start to a vertex; empty where no path leads, or the cheapest passes a vertex twice.
  HalfEdgeChain path_to(const SmoothPaths& paths, VertexHandle end) const;

  /// Root of the area, scene units.
  double size() const { return size_; }

  bool is_forbidden(VertexHandle v) const { return forbidden_.vertices[v.idx()] != 0; }
  bool is_forbidden(EdgeHandle e) const { return forbidden_.edges[e.idx()] != 0; }

 private:
  double landing_cost(HalfedgeHandle leaving) const;
  double turn(HalfedgeHandle in, HalfedgeHandle out) const;

  const HalfEdgeMesh& mesh_;
  double size_;
  Forbidden forbidden_;
  std::vector<double> direction_;  // per half-edge: angle around the vertex it leaves
  std::vector<double> full_turn_;  // per vertex: the sum of its angles
};

}  // namespace wirewarp
