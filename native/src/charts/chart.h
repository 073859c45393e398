// SPDX-License-Identifier: GPL-3.0-or-later
// A chart: one connected region between seams (the paper's patch P), with the wires and the outline it carries.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "mesh/half_edge_mesh.h"
#include "wirewarp/flatten.h"

namespace wirewarp {

/// A run of chart half-edges, each from the previous one's end. Boundary half-edges are the ones that have a face, so
/// the chart lies on their left.
using HalfEdgeChain = std::vector<HalfedgeHandle>;

/// The part of a user's wire between two vertices that lie on a seam or boundary, inside this chart. A run of edges on
/// the chart's boundary is a part of kind boundary.
struct WirePart {
  int wire_index = -1;
  int part = -1;  // counted along the whole wire, over all charts
  WireKind kind = WireKind::rigid;
  double tolerance = 0;
  HalfEdgeChain half_edges;
};

/// One stretch of the outline between junctions of seams and boundaries.
struct BoundaryChain {
  HalfEdgeChain half_edges;
  int seam = -1;  // index into the seams of the whole input, -1 none
};

struct Chart {
  HalfEdgeMesh mesh;               // consistently oriented, manifold, connected; empty if the faces do not allow that
  std::vector<int> source_vertex;  // input vertex of each chart vertex
  std::vector<int> source_face;    // input face of each chart face
  std::vector<WirePart> wire_parts;
  std::vector<BoundaryChain> boundary_chains;
  std::vector<HalfEdgeChain> boundary_loops;  // [0] is the outer one, the others are holes; the chart on the left
  std::optional<FlattenError> error;          // set: the chart cannot be flattened, and its parts and chains are empty
};

/// The ends of an edge in the input, the smaller index first.
inline VertexPair source_edge(const Chart& chart, HalfedgeHandle h) {
  const auto [first, last] = std::minmax({chart.source_vertex[chart.mesh.from_vertex_handle(h).idx()],
                                          chart.source_vertex[chart.mesh.to_vertex_handle(h).idx()]});
  return {first, last};
}

/// A wire runs through the chart, not only along its outline.
inline bool has_wires(const Chart& chart) {
  return std::any_of(chart.wire_parts.begin(), chart.wire_parts.end(),
                     [](const WirePart& part) { return part.kind != WireKind::boundary; });
}

/// A chain of seam edges between junctions and what lies at its sides.
struct Seam {
  std::vector<VertexPair> edges;  // input vertices
  struct Side {
    int chart;
    int boundary_chain;  // index into that chart's boundary_chains, -1 if the chart has an error
  };
  std::vector<Side> sides;
};

/// The whole input, cut along its seams.
struct Charts {
  std::vector<Chart> charts;
  std::vector<Seam> seams;
  std::vector<char> is_boundary_wire;  // per wire of the input: wholly on seams and boundaries
};

}  // namespace wirewarp
