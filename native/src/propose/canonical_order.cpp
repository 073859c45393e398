// SPDX-License-Identifier: GPL-3.0-or-later
#include "propose/canonical_order.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "feasibility/cut_apart.h"
#include "mesh/geometry.h"
#include "stop_token.h"

namespace wirewarp {
namespace {

/// Numbers that differ by less, over the root of the area or in radians, are the same: what turning the input leaves.
constexpr double kSame = 1e-7;

/// A vertex of the outline and the edge after it, as they look from anywhere.
using OutlineStep = std::array<double, 3>;  // length of the edge, angle inside, number of edges

struct OutlineWalk {
  std::vector<VertexHandle> vertices;
  std::vector<OutlineStep> steps;
};

/// Around the outer loop with the chart on the left, or backwards.
OutlineWalk walk_outline(const Chart& chart, bool backwards) {
  const HalfEdgeMesh& mesh = chart.mesh;
  HalfEdgeChain loop = chart.boundary_loops.front();
  if (backwards) {
    std::reverse(loop.begin(), loop.end());
    for (HalfedgeHandle& h : loop) h = mesh.opposite_halfedge_handle(h);
  }
  const double size = std::sqrt(surface_area(mesh));
  OutlineWalk walk;
  for (const HalfedgeHandle h : loop) {
    const VertexHandle v = mesh.from_vertex_handle(h);
    double angle = 0;
    for (const HalfedgeHandle out : mesh.voh_range(v)) angle += mesh.is_boundary(out) ? 0 : corner_angle(mesh, out);
    walk.vertices.push_back(v);
    walk.steps.push_back({edge_length(mesh, h) / size, angle, static_cast<double>(mesh.valence(v))});
  }
  return walk;
}

/// The walk from one place comes before that from another.
bool comes_before(const OutlineWalk& a, std::size_t a_start, const OutlineWalk& b, std::size_t b_start) {
  const std::size_t count = a.steps.size();
  for (std::size_t i = 0; i < count; ++i) {
    const OutlineStep& of_a = a.steps[(a_start + i) % count];
    const OutlineStep& of_b = b.steps[(b_start + i) % count];
    for (std::size_t k = 0; k < of_a.size(); ++k) {
      if (std::abs(of_a[k] - of_b[k]) > kSame) return of_a[k] < of_b[k];
    }
  }
  return false;
}

/// Where a numbering begins, and whether it goes around vertices backwards.
struct Start {
  HalfedgeHandle first;
  bool backwards = false;
};

Start start_on_outline(const Chart& chart) {
  const OutlineWalk walks[2] = {walk_outline(chart, false), walk_outline(chart, true)};
  std::size_t best_walk = 0, best_start = 0;
  for (std::size_t w = 0; w < 2; ++w) {
    for (std::size_t start = 0; start < walks[w].steps.size(); ++start) {
      if (!comes_before(walks[w], start, walks[best_walk], best_start)) continue;
      best_walk = w;
      best_start = start;
    }
  }
  const OutlineWalk& walk = walks[best_walk];
  const VertexHandle first = walk.vertices[best_start], second = walk.vertices[(best_start + 1) % walk.vertices.size()];
  return {chart.mesh.find_halfedge(first, second), best_walk == 1};
}

/// Numbers vertices, nearest neighbors first: each one's in their order around it.
class SurfaceWalk {
 public:
  /// rank: -1 for each vertex; set to its number, and back once the walk is over.
  SurfaceWalk(const HalfEdgeMesh& mesh, Start start, std::vector<int>& rank)
      : mesh_(mesh), backwards_(start.backwards), rank_(rank) {
    find(mesh.from_vertex_handle(start.first), start.first);
  }
  ~SurfaceWalk() {
    for (const VertexHandle v : order_) rank_[v.idx()] = -1;
  }
  SurfaceWalk(const SurfaceWalk&) = delete;
  SurfaceWalk& operator=(const SurfaceWalk&) = delete;

  /// The next half-edge, around one vertex after the other; not valid where all have been seen.
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
  std::vector<HalfedgeHandle> leaving_;  // where to begin around each
  std::size_t at_ = 0;
  HalfedgeHandle next_;
};

std::vector<VertexHandle> breadth_first(const HalfEdgeMesh& mesh, Start start) {
  std::vector<int> rank(mesh.n_vertices(), -1);
  SurfaceWalk walk(mesh, start, rank);
  while (walk.step().is_valid()) continue;
  return walk.order();
}

/// At one of the longest edges. Mostly there are few, and they differ after a few steps; on a surface of revolution
/// there are as many as segments, and each takes a walk of the whole surface.
Start start_on_closed(const HalfEdgeMesh& mesh, const std::function<bool()>& go_on) {
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
    if (!go_on()) throw Stopped();
    for (const bool backwards : {false, true}) {
      const Start start{h, backwards};
      if (!best.first.is_valid() || walk_comes_before(start, best)) best = start;
    }
  }
  return best;
}

}  // namespace

Chart in_canonical_order(const Chart& chart, const std::function<bool()>& go_on) {
  const HalfEdgeMesh& mesh = chart.mesh;
  const Start start = chart.boundary_loops.empty() ? start_on_closed(mesh, go_on) : start_on_outline(chart);
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
  return renumbered(chart, vertices, faces);
}

}  // namespace wirewarp
