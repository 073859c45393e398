// SPDX-License-Identifier: GPL-3.0-or-later
// A chart: one connected region between seams (the paper's patch P), with its wires and its outline.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "surface/mesh/half_edge_mesh.h"
#include "surface/mesh/vertex_pairs.h"
#include "wirewarp/flatten.h"

namespace wirewarp {

/// Consecutive half-edges of a chart. On a boundary, these are the half-edges with a face, so the chart is on the left.
using HalfEdgeChain = std::vector<HalfedgeHandle>;

/// A part of a user's wire in this chart, between vertices on seams or boundaries. On a boundary, each side of a run of
/// edges is a part. All sides share one h (see Wire).
struct WirePart {
  int wire_index = -1;
  int part = -1;  // index of the part along the whole wire, over all charts
  WireKind kind = WireKind::rigid;
  double tolerance = 0;  // |h - ease| <= tolerance
  HalfEdgeChain half_edges;
  double ease = 0;
};

/// Returns the bound on |g|. Solvers find g, the relative change of the target lengths at h = ease: the solved lengths
/// are (1 + g) times these lengths.
inline double solver_tolerance(const WirePart& part) { return part.tolerance / (1 + part.ease); }

/// Returns h for g, the relative change of the target length that a solver found.
inline double variation_of(const WirePart& part, double g) {
  return std::clamp(part.ease + (1 + part.ease) * g, part.ease - part.tolerance, part.ease + part.tolerance);
}

inline bool is_elastic_boundary(const WirePart& part) { return part.kind == WireKind::boundary && part.tolerance > 0; }

/// Returns whether a part is a wire inside the piece with a length to keep.
inline bool is_held(const WirePart& part) { return part.kind == WireKind::rigid || part.kind == WireKind::elastic; }

/// Returns whether a part has a length of its own to keep: it is held, or an elastic run on the boundary.
inline bool has_own_length(const WirePart& part) { return is_elastic_boundary(part) || is_held(part); }

/// One section of the outline between junctions of seams and boundaries.
struct BoundaryChain {
  HalfEdgeChain half_edges;
  int seam = -1;  // index into the seams of the whole input; -1: not a seam
};

struct Chart {
  HalfEdgeMesh mesh;               // consistently oriented, manifold, connected; empty if the faces have faults
  std::vector<int> source_vertex;  // input vertex of each chart vertex
  std::vector<int> source_face;    // input face of each chart face
  std::vector<WirePart> wire_parts;
  std::vector<double> length_ratio;  // per edge of the mesh: target length at h = ease divided by 3D length, that is
                                     // (1 + r)(1 + ease) with r from Ease; 1 for edges beyond the end of the list
  std::vector<BoundaryChain> boundary_chains;
  std::vector<HalfEdgeChain> boundary_loops;  // [0] is the outer loop, others are holes; the chart is on the left
  std::optional<FlattenError> error;          // set if the chart cannot be flattened; parts and chains are then empty
  std::optional<Positions2> free_map;  // Problem::free_map() of this mesh, if known; reset it if the mesh changes
};

/// Returns the target length at h = ease, divided by the 3D length.
inline double length_ratio(const Chart& chart, HalfedgeHandle h) {
  const auto edge = static_cast<std::size_t>(chart.mesh.edge_handle(h).idx());
  return edge < chart.length_ratio.size() ? chart.length_ratio[edge] : 1;
}

/// Sets the target lengths of a chart that was made from some faces of a parent chart. chart.source_face must refer to
/// the faces of the parent.
void inherit_lengths(const Chart& parent, Chart& chart);

/// Returns the input vertices at the ends of a half-edge.
inline VertexPair source_ends(const Chart& chart, HalfedgeHandle h) {
  return {chart.source_vertex[chart.mesh.from_vertex_handle(h).idx()],
          chart.source_vertex[chart.mesh.to_vertex_handle(h).idx()]};
}

/// Returns the input vertices at the ends of an edge, the smaller index first.
inline VertexPair source_edge(const Chart& chart, HalfedgeHandle h) { return sorted(source_ends(chart, h)); }

/// Returns whether a wire runs inside the chart, not only along its outline.
inline bool has_wires(const Chart& chart) {
  return std::any_of(chart.wire_parts.begin(), chart.wire_parts.end(),
                     [](const WirePart& part) { return part.kind != WireKind::boundary; });
}

/// A chain of seam edges between junctions, and its sides.
struct Seam {
  std::vector<VertexPair> edges;  // input vertices
  struct Side {
    int chart;
    int boundary_chain;  // index into boundary_chains of the chart, -1 if the chart has an error
  };
  std::vector<Side> sides;
};

/// The whole input, cut along its seams.
struct Charts {
  std::vector<Chart> charts;
  std::vector<Seam> seams;
  std::vector<char> is_boundary_wire;  // per wire of the input: whether the whole wire is on seams and boundaries
};

}  // namespace wirewarp
