// SPDX-License-Identifier: GPL-3.0-or-later
#include "cuts/parts/level_lines.h"

#include <algorithm>

namespace wirewarp {
namespace {

/// The level set of a function in the triangles of a mesh. Each line has larger values on its left.
class LevelSet {
 public:
  LevelSet(const HalfEdgeMesh& mesh, const Eigen::VectorXd& values, double level)
      : mesh_(mesh), values_(values), level_(level) {}

  /// Returns whether the function rises through the level along a half-edge. If so, a line leaves the half-edge's face
  /// through this half-edge.
  bool rises(HalfedgeHandle h) const {
    return values_[mesh_.from_vertex_handle(h).idx()] < level_ && values_[mesh_.to_vertex_handle(h).idx()] >= level_;
  }

  /// A line enters the face of `in` through `in`. Returns the half-edge through which the line leaves this face.
  HalfedgeHandle way_out(HalfedgeHandle in) const {
    const HalfedgeHandle next = mesh_.next_halfedge_handle(in);
    return rises(next) ? next : mesh_.next_halfedge_handle(next);
  }

  PathPoint on(HalfedgeHandle h) const {
    const double from = values_[mesh_.from_vertex_handle(h).idx()], to = values_[mesh_.to_vertex_handle(h).idx()];
    return PathPoint::on_edge(h, std::clamp((level_ - from) / (to - from), 0.0, 1.0));
  }

 private:
  const HalfEdgeMesh& mesh_;
  const Eigen::VectorXd& values_;
  const double level_;
};

}  // namespace

std::vector<MeshPath> level_lines(const HalfEdgeMesh& mesh, const Eigen::VectorXd& values, double level) {
  const LevelSet set(mesh, values, level);
  std::vector<char> is_done(mesh.n_halfedges(), 0);
  std::vector<MeshPath> lines;
  const auto follow = [&](HalfedgeHandle in, MeshPath line) {
    while (true) {
      const HalfedgeHandle out = set.way_out(in);
      line.push_back(set.on(out));
      in = mesh.opposite_halfedge_handle(out);
      if (is_done[out.idx()] != 0 || mesh.is_boundary(in)) break;
      is_done[out.idx()] = 1;
    }
    lines.push_back(std::move(line));
  };
  for (const HalfedgeHandle h : mesh.halfedges()) {
    if (mesh.is_boundary(h) && set.rises(h)) {
      const HalfedgeHandle in = mesh.opposite_halfedge_handle(h);
      follow(in, {set.on(in)});
    }
  }
  for (const HalfedgeHandle h : mesh.halfedges()) {
    if (mesh.is_boundary(h) || mesh.is_boundary(mesh.opposite_halfedge_handle(h)) || !set.rises(h)) continue;
    if (is_done[h.idx()] != 0) continue;
    is_done[h.idx()] = 1;
    follow(mesh.opposite_halfedge_handle(h), {set.on(h)});
  }
  return lines;
}

double level_length(const HalfEdgeMesh& mesh, const Eigen::VectorXd& values, double level) {
  const LevelSet set(mesh, values, level);
  double length = 0;
  for (const HalfedgeHandle out : mesh.halfedges()) {
    if (mesh.is_boundary(out) || !set.rises(out)) continue;
    const HalfedgeHandle next = mesh.next_halfedge_handle(out), last = mesh.next_halfedge_handle(next);
    const HalfedgeHandle in = set.rises(mesh.opposite_halfedge_handle(next)) ? next : last;
    length += (position(mesh, set.on(out)) - position(mesh, set.on(in))).norm();
  }
  return length;
}

}  // namespace wirewarp
