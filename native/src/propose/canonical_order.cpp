// SPDX-License-Identifier: GPL-3.0-or-later
#include "propose/canonical_order.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "feasibility/cut_apart.h"
#include "mesh/geometry.h"

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

/// All vertices, nearest neighbors first: each one's in their order around it.
std::vector<VertexHandle> breadth_first(const HalfEdgeMesh& mesh, HalfedgeHandle first, bool backwards) {
  std::vector<VertexHandle> order;
  std::vector<HalfedgeHandle> leaving;  // where to begin around each
  std::vector<char> is_found(mesh.n_vertices(), 0);
  const auto find = [&](VertexHandle v, HalfedgeHandle from) {
    if (std::exchange(is_found[v.idx()], 1) != 0) return;
    order.push_back(v);
    leaving.push_back(from);
  };
  find(mesh.from_vertex_handle(first), first);
  for (std::size_t i = 0; i < order.size(); ++i) {
    HalfedgeHandle h = leaving[i];
    do {
      find(mesh.to_vertex_handle(h), mesh.opposite_halfedge_handle(h));
      h = backwards ? mesh.cw_rotated_halfedge_handle(h) : mesh.ccw_rotated_halfedge_handle(h);
    } while (h != leaving[i]);
  }
  return order;
}

}  // namespace

Chart in_canonical_order(const Chart& chart) {
  const HalfEdgeMesh& mesh = chart.mesh;
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
  const HalfedgeHandle first =
      mesh.find_halfedge(walk.vertices[best_start], walk.vertices[(best_start + 1) % walk.vertices.size()]);
  const std::vector<VertexHandle> vertices = breadth_first(mesh, first, best_walk == 1);
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
