// SPDX-License-Identifier: GPL-3.0-or-later
#include "warp/topology/straightest_geodesic.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>

#include "surface/mesh/geometry.h"

namespace wirewarp {
namespace {

/// Tolerance for rounding errors: a path this close to a vertex (in edge lengths) or to an edge (in radians) counts as
/// being on the vertex or edge.
constexpr double kOnIt = 1e-11;

class Tracer {
 public:
  Tracer(const HalfEdgeMesh& mesh, const WireMask& wires) : mesh_(mesh), wires_(wires) {}

  std::optional<MeshPath> trace(HalfedgeHandle reference, double angle) {
    arrive_at_vertex(reference, angle);
    has_arrived_ = false;
    while (!has_arrived_ && !has_come_back_) {
      if (is_at_vertex_) {
        leave_vertex();
      } else {
        cross_face();
      }
    }
    if (has_come_back_) return std::nullopt;
    return std::move(path_);
  }

 private:
  /// Arrives at the start of h. angle: direction in which leave_vertex() leaves, counter-clockwise from h.
  void arrive_at_vertex(HalfedgeHandle h, double angle) {
    const VertexHandle v = mesh_.from_vertex_handle(h);
    path_.push_back(PathPoint::at_vertex(v));
    is_at_vertex_ = true;
    has_arrived_ = wires_.has(v);
    has_come_back_ = has_come_back_ || !passed_vertices_.insert(v.idx()).second;
    entry_ = h;
    angle_ = angle;
  }

  void leave_vertex() {
    while (std::abs(angle_) > kOnIt && !mesh_.is_boundary(entry_)) {
      const double corner = corner_angle(mesh_, entry_);
      if (angle_ < corner - kOnIt) return enter_face_from_vertex();
      angle_ -= corner;
      entry_ = next_counterclockwise(mesh_, entry_);
    }
    const HalfedgeHandle back = mesh_.opposite_halfedge_handle(entry_);
    arrive_at_vertex(back, total_angle(mesh_, mesh_.from_vertex_handle(back)) / 2);
  }

  void enter_face_from_vertex() {
    is_at_vertex_ = false;
    direction_ = std::polar(1.0, angle_);
    pass_face();
    cross_side(mesh_.next_halfedge_handle(entry_), edge_length(mesh_, entry_), apex_over(mesh_, entry_), 0);
  }

  /// Crosses the face of entry_ from a point on entry_.
  void cross_face() {
    pass_face();
    const Planar b = edge_length(mesh_, entry_);
    const Planar c = apex_over(mesh_, entry_);
    const Planar p = entry_t_ * b;
    if (cross(c - p, direction_) > 0) {
      cross_side(mesh_.prev_halfedge_handle(entry_), c, 0, p);
    } else {
      cross_side(mesh_.next_halfedge_handle(entry_), b, c, p);
    }
  }

  /// Leaves the face through `side`, which runs from q0 to q1 in the plane of entry_. p: the point from which the
  /// geodesic comes.
  void cross_side(HalfedgeHandle side, Planar q0, Planar q1, Planar p) {
    const double left = cross(q0 - p, direction_);
    const double right = cross(direction_, q1 - p);
    const double t = left / (left + right);
    if (t <= kOnIt) return meet_vertex(side, q1 - q0);
    if (t >= 1 - kOnIt) {
      const HalfedgeHandle next = mesh_.next_halfedge_handle(side);
      return meet_vertex(next, point_in_face(next) - q1);
    }
    path_.push_back(PathPoint::on_edge(side, t));
    if (wires_.has(mesh_.edge_handle(side))) {
      has_arrived_ = true;
      return;
    }
    direction_ *= -std::conj(q1 - q0) / std::abs(q1 - q0);
    direction_ /= std::abs(direction_);
    entry_ = mesh_.opposite_halfedge_handle(side);
    entry_t_ = 1 - t;
  }

  /// Returns the end of a half-edge of entry_'s face, in the plane of entry_.
  Planar point_in_face(HalfedgeHandle h) const {
    if (h == entry_) return edge_length(mesh_, entry_);
    return h == mesh_.next_halfedge_handle(entry_) ? apex_over(mesh_, entry_) : Planar(0);
  }

  /// Arrives at the start of h after crossing h's face. h_direction: direction of h in the plane of entry_.
  void meet_vertex(HalfedgeHandle h, Planar h_direction) {
    const double total = total_angle(mesh_, mesh_.from_vertex_handle(h));
    const double angle = std::arg(-direction_ / h_direction) + total / 2;
    arrive_at_vertex(h, angle < total ? std::max(angle, 0.0) : angle - total);
  }

  void pass_face() { has_come_back_ = has_come_back_ || !passed_faces_.insert(mesh_.face_handle(entry_).idx()).second; }

  const HalfEdgeMesh& mesh_;
  const WireMask& wires_;
  MeshPath path_;
  bool is_at_vertex_ = false;
  HalfedgeHandle entry_;  // defines the plane: origin at its start, real axis along it, its face on the left
  double angle_ = 0;      // at a vertex: angle from entry_, which starts there
  double entry_t_ = 0;    // on an edge: position along entry_, in edge lengths
  Planar direction_;      // on an edge: unit vector in the plane of entry_
  bool has_arrived_ = false;
  bool has_come_back_ = false;
  std::unordered_set<int> passed_faces_;
  std::unordered_set<int> passed_vertices_;
};

}  // namespace

std::optional<MeshPath> trace_straightest(const HalfEdgeMesh& mesh, const WireMask& wires, HalfedgeHandle reference,
                                          double angle) {
  return Tracer(mesh, wires).trace(reference, angle);
}

}  // namespace wirewarp
