// SPDX-License-Identifier: GPL-3.0-or-later
#include "cuts/propose/canonical_order.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/work_meter.h"
#include "cuts/feasibility/cut_apart.h"
#include "cuts/feasibility/ranks.h"
#include "surface/mesh/geometry.h"

namespace wirewarp {
namespace {

/// Largest difference between equal lengths (over √area) and between equal angles (in radians). It is a thousand times
/// the rounding error of rotated input, and far below the differences between edges of a large outline.
constexpr double kSame = 1e-9;

/// The first half-edge of a numbering, and whether the numbering goes clockwise around vertices.
struct Start {
  HalfedgeHandle first;
  bool backwards = false;
};

/// Describes a vertex of the outline and the edge after it by numbers that do not depend on positions: the rank of the
/// edge's length, the rank of the inner angle, and the number of edges at the vertex.
using OutlineStep = std::array<int, 3>;

/// Returns the walk around the outer loop with the chart on the left, and the walk in the opposite direction, both from
/// the same vertex.
std::array<std::vector<OutlineStep>, 2> walk_outline(const Chart& chart) {
  const HalfEdgeMesh& mesh = chart.mesh;
  const HalfEdgeChain& loop = chart.boundary_loops.front();
  const double size = std::sqrt(surface_area(mesh));
  std::vector<double> lengths, angles;
  for (const HalfedgeHandle h : loop) {
    lengths.push_back(edge_length(mesh, h) / size);
    angles.push_back(total_angle(mesh, mesh.from_vertex_handle(h)));
  }
  const std::vector<int> length_ranks = ranks_of(lengths, kSame), angle_ranks = ranks_of(angles, kSame);
  std::array<std::vector<OutlineStep>, 2> walks;
  const std::size_t count = loop.size();
  for (std::size_t i = 0; i < count; ++i) {
    const auto step_at = [&](std::size_t at, std::size_t edge) -> OutlineStep {
      return {length_ranks[edge], angle_ranks[at], static_cast<int>(mesh.valence(mesh.from_vertex_handle(loop[at])))};
    };
    walks[0].push_back(step_at(i, i));
    walks[1].push_back(step_at((count - i) % count, count - 1 - i));
  }
  return walks;
}

/// Returns the start of the lexicographically least rotation, in linear time (Duval, Factorizing words over an ordered
/// alphabet, 1983).
std::size_t least_rotation(const std::vector<OutlineStep>& ring, WorkMeter& work) {
  const std::size_t count = ring.size();
  std::size_t a = 0, b = 1, same = 0;
  while (a < count && b < count && same < count) {
    work.did(1);
    const OutlineStep &of_a = ring[(a + same) % count], &of_b = ring[(b + same) % count];
    if (of_a == of_b) {
      ++same;
      continue;
    }
    // No rotation that starts in the compared section of the greater rotation is the least, so these starts are
    // skipped.
    (of_b < of_a ? a : b) += same + 1;
    if (a == b) ++b;
    same = 0;
  }
  return std::min(a, b);
}

Start start_on_outline(const Chart& chart, WorkMeter& work) {
  const HalfEdgeMesh& mesh = chart.mesh;
  auto [forth, back] = walk_outline(chart);
  const std::size_t forwards = least_rotation(forth, work), backwards = least_rotation(back, work);
  std::rotate(forth.begin(), forth.begin() + static_cast<std::ptrdiff_t>(forwards), forth.end());
  std::rotate(back.begin(), back.begin() + static_cast<std::ptrdiff_t>(backwards), back.end());
  const HalfEdgeChain& loop = chart.boundary_loops.front();
  if (forth <= back) return {loop[forwards], false};
  return {mesh.opposite_halfedge_handle(loop[loop.size() - 1 - backwards]), true};
}

/// Numbers vertices breadth first. The neighbors of a vertex are numbered in their order around it.
class SurfaceWalk {
 public:
  /// rank: -1 for each vertex. It contains the vertices' numbers during the walk, and is reset to -1 afterwards.
  SurfaceWalk(const HalfEdgeMesh& mesh, Start start, std::vector<int>& rank)
      : mesh_(mesh), backwards_(start.backwards), rank_(rank) {
    find(mesh.from_vertex_handle(start.first), start.first);
  }
  ~SurfaceWalk() {
    for (const VertexHandle v : order_) rank_[v.idx()] = -1;
  }
  SurfaceWalk(const SurfaceWalk&) = delete;
  SurfaceWalk& operator=(const SurfaceWalk&) = delete;

  /// Returns the next half-edge of the walk around one vertex after the other. Returns an invalid handle at the end of
  /// the walk.
  HalfedgeHandle step() {
    if (!next_.is_valid()) {
      if (at_ == order_.size()) return next_;
      next_ = leaving_[at_];
    }
    const HalfedgeHandle h = next_;
    find(mesh_.to_vertex_handle(h), mesh_.opposite_halfedge_handle(h));
    next_ = backwards_ ? mesh_.cw_rotated_halfedge_handle(h) : mesh_.ccw_rotated_halfedge_handle(h);
    if (next_ == leaving_[at_]) {
      next_ = HalfedgeHandle();
      ++at_;
    }
    return h;
  }

  int rank_of_end(HalfedgeHandle h) const { return rank_[mesh_.to_vertex_handle(h).idx()]; }
  const std::vector<VertexHandle>& order() const { return order_; }

 private:
  void find(VertexHandle v, HalfedgeHandle leaving) {
    if (rank_[v.idx()] >= 0) return;
    rank_[v.idx()] = static_cast<int>(order_.size());
    order_.push_back(v);
    leaving_.push_back(leaving);
  }

  const HalfEdgeMesh& mesh_;
  const bool backwards_;
  std::vector<int>& rank_;
  std::vector<VertexHandle> order_;
  std::vector<HalfedgeHandle> leaving_;  // first half-edge around each vertex
  std::size_t at_ = 0;
  HalfedgeHandle next_;
};

std::vector<VertexHandle> breadth_first(const HalfEdgeMesh& mesh, Start start) {
  std::vector<int> rank(mesh.n_vertices(), -1);
  SurfaceWalk walk(mesh, start, rank);
  while (walk.step().is_valid()) continue;
  return walk.order();
}

/// Returns a start at one of the longest edges: the one whose walk comes first if walks are compared step by step. A
/// surface of revolution takes long: it has one longest edge per segment, and each needs a walk over the whole surface.
Start start_on_closed(const HalfEdgeMesh& mesh, const StopToken& stop) {
  double longest = 0;
  for (const EdgeHandle e : mesh.edges()) longest = std::max(longest, edge_length(mesh, mesh.halfedge_handle(e, 0)));
  const double same = kSame * std::sqrt(surface_area(mesh));
  std::vector<int> rank_of_best(mesh.n_vertices(), -1), rank(mesh.n_vertices(), -1);
  const auto walk_comes_before = [&](Start a, Start b) {
    SurfaceWalk of_a(mesh, a, rank), of_b(mesh, b, rank_of_best);
    while (true) {
      const HalfedgeHandle h = of_a.step(), g = of_b.step();
      if (!h.is_valid()) return false;
      const double longer = edge_length(mesh, h) - edge_length(mesh, g);
      if (std::abs(longer) > same) return longer < 0;
      if (of_a.rank_of_end(h) != of_b.rank_of_end(g)) return of_a.rank_of_end(h) < of_b.rank_of_end(g);
    }
  };
  Start best;
  for (const HalfedgeHandle h : mesh.halfedges()) {
    if (edge_length(mesh, h) < longest - same) continue;
    stop.check();
    for (const bool backwards : {false, true}) {
      const Start start{h, backwards};
      if (!best.first.is_valid() || walk_comes_before(start, best)) best = start;
    }
  }
  return best;
}

}  // namespace

Chart in_canonical_order(const Chart& chart, const StopToken& stop) {
  const HalfEdgeMesh& mesh = chart.mesh;
  WorkMeter work(stop);
  const Start start = chart.boundary_loops.empty() ? start_on_closed(mesh, stop) : start_on_outline(chart, work);
  const std::vector<VertexHandle> vertices = breadth_first(mesh, start);
  std::vector<int> rank(mesh.n_vertices());
  for (std::size_t i = 0; i < vertices.size(); ++i) rank[vertices[i].idx()] = static_cast<int>(i);

  const Triangles triangles = triangles_of(mesh).unaryExpr([&](int v) { return rank[v]; });
  std::vector<FaceHandle> faces(mesh.faces_begin(), mesh.faces_end());
  const auto corners_of = [&](FaceHandle f) {
    std::array<int, 3> corners{triangles(f.idx(), 0), triangles(f.idx(), 1), triangles(f.idx(), 2)};
    std::sort(corners.begin(), corners.end());
    return corners;
  };
  std::sort(faces.begin(), faces.end(), [&](FaceHandle f, FaceHandle g) { return corners_of(f) < corners_of(g); });
  Chart ordered = renumbered(chart, vertices, faces);
  for (int& v : ordered.source_vertex) v = chart.source_vertex[v];
  for (int& f : ordered.source_face) f = chart.source_face[f];
  return ordered;
}

}  // namespace wirewarp
