// SPDX-License-Identifier: GPL-3.0-or-later
#include "warp/topology/straight_walk.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "base/planar.h"
#include "surface/mesh/geometry.h"

namespace wirewarp {
namespace {

/// Share of a length or area below which differences count as rounding errors.
constexpr double kRoundedShare = 1e-12;

/// A line is rarely longer than this many times the distance in space. So a search up to this length comes first,
/// because it is faster.
constexpr double kUsually = 1.5;

/// Returns the start, end and apex of a half-edge's face in the plane. The start is at 0, and the half-edge is along
/// the real axis.
std::array<Planar, 3> corners_over(const HalfEdgeMesh& mesh, HalfedgeHandle h) {
  return {Planar(0), Planar(edge_length(mesh, h)), apex_over(mesh, h)};
}

Planar direction(Planar vector) { return vector / std::abs(vector); }

/// Returns the angle around a vertex from its first half-edge to another half-edge, in the plane of the vertex.
double angle_of(const HalfEdgeMesh& mesh, HalfedgeHandle h) {
  const VertexHandle v = mesh.from_vertex_handle(h);
  double angle = 0;
  for (HalfedgeHandle at = mesh.halfedge_handle(v); at != h; at = next_counterclockwise(mesh, at))
    angle += corner_angle(mesh, at);
  return angle * 2 * kPi / total_angle(mesh, v);
}

/// Looks in all directions from a point in a face, for another point or for all vertices.
class View {
 public:
  View(const HalfEdgeMesh& mesh, const std::vector<char>& barriers, const SurfacePoint& from, double longest)
      : mesh_(mesh), barriers_(barriers), from_(from), longest_(longest) {}

  std::optional<StraightLine> to(const SurfacePoint& end) {
    end_ = &end;
    look();
    return std::move(found_);
  }

  struct Seen {
    VertexHandle vertex;
    Planar leaving;
    MeshPath crossings;
  };

  std::vector<Seen> vertices() {
    look();
    return std::move(seen_);
  }

 private:
  /// A half-edge through which the directions from `right` to `left` leave a face.
  struct Window {
    HalfedgeHandle half_edge;
    Planar start, end;  // ends of half_edge
    Planar right, left;
  };

  void look() {
    const HalfedgeHandle first = mesh_.halfedge_handle(from_.face);
    std::array<Planar, 3> corners = corners_over(mesh_, first);
    for (Planar& corner : corners) corner -= from_.place;
    std::array<HalfedgeHandle, 3> sides{first, mesh_.next_halfedge_handle(first), mesh_.prev_halfedge_handle(first)};
    for (int k = 0; k < 3; ++k) see_vertex(sides[k], corners[k], corners[(k + 1) % 3]);
    see_end(from_.face, direction(corners[1] - corners[0]), corners[0]);
    for (int k = 0; k < 3; ++k) {
      const Planar start = corners[k], end = corners[(k + 1) % 3];
      look_through({sides[k], start, end, start, end});
    }
  }

  bool may_cross(HalfedgeHandle h) const {
    return barriers_[mesh_.edge_handle(h).idx()] == 0 && !mesh_.is_boundary(mesh_.opposite_halfedge_handle(h));
  }

  bool is_in(const Window& window, Planar place) const {
    const double rounding = kRoundedShare * std::norm(place);
    return cross(window.right, place) >= -rounding && cross(place, window.left) >= -rounding;
  }

  /// Returns the distance to the visible part of the half-edge.
  static double distance_to(const Window& window) {
    const Planar along = direction(window.end - window.start);
    const auto seen_at = [&](Planar way) { return cross(window.start, way) / cross(way, along); };
    const double length = std::abs(window.end - window.start);
    const double nearest = std::real(std::conj(along) * -window.start);
    const double first = window.right == window.start ? 0 : std::clamp(seen_at(window.right), 0.0, length);
    const double last = window.left == window.end ? length : std::clamp(seen_at(window.left), first, length);
    return std::abs(window.start + std::clamp(nearest, first, last) * along);
  }

  void look_through(const Window& window) {
    if (!may_cross(window.half_edge) || distance_to(window) >= longest_) return;
    windows_.push_back(window);
    const HalfedgeHandle back = mesh_.opposite_halfedge_handle(window.half_edge);
    const Planar unit = direction(window.start - window.end);
    const Planar apex = window.end + unit * apex_over(mesh_, back);
    const HalfedgeHandle next = mesh_.next_halfedge_handle(back), last = mesh_.prev_halfedge_handle(back);
    if (is_in(window, apex)) see_vertex(last, apex, window.end);
    const HalfedgeHandle first = mesh_.halfedge_handle(mesh_.face_handle(back));
    const Planar origin = first == back ? window.end : first == next ? window.start : apex;
    const Planar toward = first == back ? window.start : first == next ? apex : window.end;
    see_end(mesh_.face_handle(back), direction(toward - origin), origin);
    const bool is_right_open = cross(window.right, apex) > 0, is_left_open = cross(apex, window.left) > 0;
    if (is_right_open) look_through({next, window.start, apex, window.right, is_left_open ? apex : window.left});
    if (is_left_open) look_through({last, apex, window.end, is_right_open ? apex : window.right, window.left});
    windows_.pop_back();
  }

  MeshPath crossings_to(Planar place) const {
    MeshPath crossings;
    for (const Window& window : windows_) {
      const double before = cross(window.start, place), behind = cross(place, window.end);
      const double t = before + behind == 0 ? 0.5 : before / (before + behind);
      crossings.push_back(PathPoint::on_edge(window.half_edge, std::clamp(t, 0.0, 1.0)));
    }
    return crossings;
  }

  /// leaving: a half-edge of the face in view that leaves the vertex; place, toward: start and end of this half-edge.
  void see_vertex(HalfedgeHandle leaving, Planar place, Planar toward) {
    const VertexHandle vertex = mesh_.from_vertex_handle(leaving);
    if (end_ == nullptr) {
      if (std::abs(place) < longest_) seen_.push_back({vertex, place, crossings_to(place)});
      return;
    }
    if (end_->vertex != vertex || std::abs(place) >= longest_) return;
    const double scale = mesh_.is_boundary(vertex) ? 1 : 2 * kPi / total_angle(mesh_, vertex);
    const double angle = std::max(std::arg(-place / (toward - place)), 0.0) * scale;
    const double before = mesh_.is_boundary(vertex) ? 0 : angle_of(mesh_, leaving);  // outline vertices have no plane
    found_ = StraightLine{place, std::polar(std::abs(place), before + angle), crossings_to(place)};
    longest_ = std::abs(place);
  }

  /// unit, origin: direction and start of the first half-edge of the face in view.
  void see_end(FaceHandle face, Planar unit, Planar origin) {
    if (end_ == nullptr || end_->vertex.is_valid() || end_->face != face) return;
    const Planar place = origin + unit * end_->place;
    if (std::abs(place) >= longest_ || (!windows_.empty() && !is_in(windows_.back(), place))) return;
    found_ = StraightLine{place, -place / unit, crossings_to(place)};
    longest_ = std::abs(place);
  }

  const HalfEdgeMesh& mesh_;
  const std::vector<char>& barriers_;
  const SurfacePoint& from_;
  double longest_;
  const SurfacePoint* end_ = nullptr;  // none: looks for all vertices
  std::vector<Window> windows_;        // half-edges through which the view passes now
  std::optional<StraightLine> found_;
  std::vector<Seen> seen_;
};

}  // namespace

SurfacePoint StraightWalk::step(const SurfacePoint& from, Planar vector) const {
  double left = std::abs(vector);
  if (left == 0) return from;
  HalfedgeHandle entry = from.vertex.is_valid() ? mesh_.halfedge_handle(from.vertex) : mesh_.halfedge_handle(from.face);
  Planar place = from.vertex.is_valid() ? Planar(0) : from.place, unit = vector / left;
  if (from.vertex.is_valid()) {
    double angle = std::arg(vector) / (2 * kPi);
    angle = (angle < 0 ? angle + 1 : angle) * total_angle(mesh_, from.vertex);
    for (std::size_t k = 0; k < mesh_.valence(from.vertex) && angle > corner_angle(mesh_, entry); ++k) {
      angle -= corner_angle(mesh_, entry);
      entry = next_counterclockwise(mesh_, entry);
    }
    unit = std::polar(1.0, std::min(angle, corner_angle(mesh_, entry)));
  }
  HalfedgeHandle came;
  while (true) {
    const std::array<Planar, 3> corners = corners_over(mesh_, entry);
    const std::array<HalfedgeHandle, 3> sides{entry, mesh_.next_halfedge_handle(entry),
                                              mesh_.prev_halfedge_handle(entry)};
    double nearest = std::numeric_limits<double>::infinity();
    int out = -1;
    for (int k = 0; k < 3; ++k) {
      if (sides[k] == came || (from.vertex.is_valid() && !came.is_valid() && k != 1)) continue;
      const Planar along = direction(corners[(k + 1) % 3] - corners[k]);
      const double speed = cross(unit, along);  // towards the side
      if (speed <= kRoundedShare) continue;
      const double distance = std::max(cross(along, place - corners[k]), 0.0) / speed;
      if (distance >= nearest) continue;
      nearest = distance;
      out = k;
    }
    if (left <= nearest || out < 0) {
      const HalfedgeHandle first = mesh_.halfedge_handle(mesh_.face_handle(entry));
      const int k = static_cast<int>(std::find(sides.begin(), sides.end(), first) - sides.begin());
      return SurfacePoint::in_face(mesh_.face_handle(entry),
                                   (place + left * unit - corners[k]) / direction(corners[(k + 1) % 3] - corners[k]));
    }
    const HalfedgeHandle back = mesh_.opposite_halfedge_handle(sides[out]);
    if (barriers_[mesh_.edge_handle(back).idx()] != 0 || mesh_.is_boundary(back)) return from;
    const Planar start = corners[(out + 1) % 3], along = direction(corners[out] - start);
    place = (place + nearest * unit - start) / along;
    unit = direction(unit / along);
    left -= nearest;
    entry = came = back;
  }
}

std::optional<StraightLine> StraightWalk::line(const SurfacePoint& from, const SurfacePoint& to, double longest) const {
  const double apart = (position(mesh_, to) - position(mesh_, from)).norm();
  std::optional<StraightLine> direct = View(mesh_, barriers_, from, std::min(kUsually * apart, longest)).to(to);
  if (!direct) direct = View(mesh_, barriers_, from, longest).to(to);
  if (direct || to.vertex.is_valid()) return direct;
  // If the angles around a vertex sum to more than 360 degrees, no straight line reaches a region behind the vertex.
  // The shortest line then leads through the vertex.
  std::optional<StraightLine> around;
  double least = longest;
  const std::vector<View::Seen> here = View(mesh_, barriers_, from, longest).vertices();
  for (const View::Seen& there : View(mesh_, barriers_, to, longest).vertices()) {
    for (const View::Seen& seen : here) {
      const double length = std::abs(seen.leaving) + std::abs(there.leaving);
      if (seen.vertex != there.vertex || length >= least) continue;
      least = length;
      around = StraightLine{length * direction(seen.leaving), length * direction(there.leaving), seen.crossings};
      around->between.push_back(PathPoint::at_vertex(seen.vertex));
      for (auto point = there.crossings.rbegin(); point != there.crossings.rend(); ++point)
        around->between.push_back(PathPoint::on_edge(mesh_.opposite_halfedge_handle(point->half_edge), 1 - point->t));
    }
  }
  return around;
}

HalfEdgeMesh::Point position(const HalfEdgeMesh& mesh, const SurfacePoint& point) {
  if (point.vertex.is_valid()) return mesh.point(point.vertex);
  const HalfedgeHandle first = mesh.halfedge_handle(point.face);
  const HalfEdgeMesh::Point origin = mesh.point(mesh.from_vertex_handle(first));
  const HalfEdgeMesh::Point along = (mesh.point(mesh.to_vertex_handle(first)) - origin).normalized();
  const HalfEdgeMesh::Point up = mesh.point(mesh.to_vertex_handle(mesh.next_halfedge_handle(first))) - origin;
  const HalfEdgeMesh::Point aside = (up - along * (along | up)).normalized();
  return origin + along * point.place.real() + aside * point.place.imag();
}

SurfacePoint point_on_edge(const HalfEdgeMesh& mesh, HalfedgeHandle h, double share) {
  const HalfedgeHandle side = mesh.is_boundary(h) ? mesh.opposite_halfedge_handle(h) : h;
  const double t = side == h ? share : 1 - share;
  const FaceHandle face = mesh.face_handle(side);
  const HalfedgeHandle first = mesh.halfedge_handle(face);
  const std::array<Planar, 3> corners = corners_over(mesh, first);
  const int k = side == first ? 0 : side == mesh.next_halfedge_handle(first) ? 1 : 2;
  return SurfacePoint::in_face(face, corners[k] + t * (corners[(k + 1) % 3] - corners[k]));
}

}  // namespace wirewarp
