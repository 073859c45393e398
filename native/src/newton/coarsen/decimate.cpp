// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/coarsen/decimate.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>

#include "base/planar.h"
#include "surface/mesh/geometry.h"

namespace wirewarp {
namespace {

// Longest new edge over the target length. A target of four edges should leave a sixteenth of the faces. Of 3,200
// faces, that is 200: with 1, 522 are left, and with 4, only 29.
constexpr double kLongestEdge = 2;
// Least quality of a new face: an equilateral face has 1, a face without area 0. All angles are then above 8 degrees.
// With half this value, quadratic maps of a curved sheet are prolonged less exactly; with twice, no test of coarse
// starts changes.
constexpr double kWorstQuality = 0.25;
// A choice counts as better only if it is better by this factor. So the rounding errors of a rotated or scaled mesh do
// not change the choice.
constexpr double kClearly = 1 + 1e-9;
// Wire vertices at which the wire turns more are not removed. With twice this angle, a quarter sphere takes four fine
// factorizations instead of three; with half, no test of coarse starts changes.
constexpr double kSharpestTurn = kPi / 4;
// A round that removes a smaller share of the vertices is the last one. Half or twice this share changes no test of
// coarse starts.
constexpr double kWorthwhile = 0.02;

/// The faces around a vertex, or on one side of its wire. They are laid out in the plane with the vertex at the origin.
/// Face i is between spokes i and i + 1.
struct Fan {
  std::vector<VertexHandle> rim;  // counter-clockwise; if the rim is closed, its first vertex is also its last
  std::vector<FaceHandle> faces;
  std::vector<Eigen::Vector2d> positions;
  double angle = 0;  // sum of the angles at the vertex, on the surface
};

class Decimation {
 public:
  Decimation(const Chart& chart, const HeldNetwork& network, double edge_length);
  void run(const StopToken& stop);
  DecimatedMesh result();

 private:
  /// The neighbors of a wire vertex along its wire; both -1 for other vertices.
  using WireNeighbors = std::array<int, 2>;
  struct Place {
    int next = -1;  // next removed vertex in the same face
    double weights[3] = {0, 0, 0};
  };

  bool is_free(int v) const { return wire_neighbors_[v][0] == -1; }
  int remove_round();
  bool try_remove(VertexHandle v);
  void lay_out(HalfedgeHandle first, VertexHandle last, double turn, Fan& fan) const;
  bool lay_out_fans(VertexHandle v);
  double worst_quality(const Fan& fan, std::size_t apex, double least) const;
  double worst_quality_towards(VertexHandle w, double least) const;
  HalfedgeHandle choose_collapse(VertexHandle v);
  void move_points(const Fan& fan, VertexHandle v, VertexHandle w);

  HalfEdgeMesh mesh_;
  double longest_edge_;
  std::vector<char> is_kept_, is_locked_;
  std::vector<WireNeighbors> wire_neighbors_;
  std::vector<std::array<int, 3>> corners_;  // corners of each face, in the order of Place::weights
  std::vector<int> first_point_;             // first removed vertex in each face
  std::vector<Place> places_;
  std::vector<int> face_of_point_;
  std::vector<Fan> fans_;
  std::size_t num_fans_ = 0;
  std::vector<int> moved_;
  std::vector<Eigen::Vector2d> moved_to_;
};

Decimation::Decimation(const Chart& chart, const HeldNetwork& network, double edge_length)
    : mesh_(chart.mesh),
      longest_edge_(kLongestEdge * edge_length),
      is_kept_(chart.mesh.n_vertices(), 0),
      is_locked_(chart.mesh.n_vertices(), 0),
      wire_neighbors_(chart.mesh.n_vertices(), {-1, -1}),
      corners_(chart.mesh.n_faces()),
      first_point_(chart.mesh.n_faces(), -1),
      places_(chart.mesh.n_vertices()),
      face_of_point_(chart.mesh.n_vertices(), -1),
      fans_(2) {
  mesh_.request_vertex_status();
  mesh_.request_edge_status();
  mesh_.request_face_status();
  const Triangles triangles = triangles_of(mesh_);
  for (int f = 0; f < triangles.rows(); ++f) {
    corners_[f] = {triangles(f, 0), triangles(f, 1), triangles(f, 2)};
  }
  std::vector<int> part(chart.mesh.n_vertices(), -1);
  for (const WireEdge& edge : network.edges) {
    const HalfedgeHandle h = mesh_.halfedge_handle(edge.edge, 0);
    const int ends[2] = {mesh_.from_vertex_handle(h).idx(), mesh_.to_vertex_handle(h).idx()};
    for (int k = 0; k < 2; ++k) {
      WireNeighbors& neighbors = wire_neighbors_[ends[k]];
      if (neighbors[0] == -1) {
        neighbors[0] = ends[1 - k];
        part[ends[k]] = edge.part;
      } else if (neighbors[1] == -1 && part[ends[k]] == edge.part) {
        neighbors[1] = ends[1 - k];
      } else {
        is_kept_[ends[k]] = 1;
      }
    }
  }
  for (std::size_t v = 0; v < is_kept_.size(); ++v) {
    if (wire_neighbors_[v][0] != -1 && wire_neighbors_[v][1] == -1) is_kept_[v] = 1;
  }
  for (const WirePart& wire : chart.wire_parts) {
    if (!has_own_length(wire)) continue;
    is_kept_[mesh_.from_vertex_handle(wire.half_edges.front()).idx()] = 1;
    is_kept_[mesh_.to_vertex_handle(wire.half_edges.back()).idx()] = 1;
  }
}

/// Fills the fan with the faces around the vertex where the half-edge `first` begins, counter-clockwise from `first` to
/// the neighbor `last`. turn: angle of the fan in the plane.
void Decimation::lay_out(HalfedgeHandle first, VertexHandle last, double turn, Fan& fan) const {
  fan.rim.clear();
  fan.faces.clear();
  fan.positions.clear();
  fan.angle = 0;
  const auto origin = mesh_.point(mesh_.from_vertex_handle(first));
  HalfedgeHandle h = first;
  auto spoke = mesh_.point(mesh_.to_vertex_handle(h)) - origin;
  fan.rim.push_back(mesh_.to_vertex_handle(h));
  fan.positions.push_back({spoke.norm(), 0});  // polar coordinates until the total angle is known
  do {
    fan.faces.push_back(mesh_.face_handle(h));
    h = next_counterclockwise(mesh_, h);
    const auto next = mesh_.point(mesh_.to_vertex_handle(h)) - origin;
    fan.angle += std::atan2((spoke % next).norm(), spoke | next);
    spoke = next;
    fan.rim.push_back(mesh_.to_vertex_handle(h));
    fan.positions.push_back({spoke.norm(), fan.angle});
  } while (fan.rim.back() != last);
  for (Eigen::Vector2d& p : fan.positions) {
    const double angle = p.y() * turn / fan.angle;
    p = {p.x() * std::cos(angle), p.x() * std::sin(angle)};
  }
}

/// Lays out the faces around a vertex. Returns false if the vertex must stay, because its wire turns too sharply.
bool Decimation::lay_out_fans(VertexHandle v) {
  num_fans_ = 0;
  if (is_free(v.idx())) {
    const HalfedgeHandle first = mesh_.halfedge_handle(v);
    lay_out(first, mesh_.to_vertex_handle(first), 2 * kPi, fans_[num_fans_++]);
    return true;
  }
  for (int k = 0; k < 2; ++k) {
    const WireNeighbors& neighbors = wire_neighbors_[v.idx()];
    const HalfedgeHandle first = mesh_.find_halfedge(v, VertexHandle(neighbors[k]));
    if (mesh_.is_boundary(first)) continue;
    Fan& fan = fans_[num_fans_++];
    lay_out(first, VertexHandle(neighbors[1 - k]), kPi, fan);
    if (std::abs(fan.angle - kPi) > kSharpestTurn) return false;
  }
  return true;
}

/// Returns the least quality, 4√3 area / Σ side², of the new faces after the fan's vertex moves to rim[apex]. Returns 0
/// if a face is flipped, has too long a side, or has a quality below `least`.
double Decimation::worst_quality(const Fan& fan, std::size_t apex, double least) const {
  double worst = 1;
  const auto& a = fan.positions[apex];
  const auto p = mesh_.point(fan.rim[apex]);
  for (std::size_t i = 0; i < fan.faces.size(); ++i) {
    if (fan.rim[i] == fan.rim[apex] || fan.rim[i + 1] == fan.rim[apex]) continue;
    const auto to_first = mesh_.point(fan.rim[i]) - p, to_second = mesh_.point(fan.rim[i + 1]) - p;
    const double first = to_first.sqrnorm(), second = to_second.sqrnorm();
    if (!(cross(fan.positions[i] - a, fan.positions[i + 1] - a) > 0)) return 0;
    if (std::max(first, second) > longest_edge_ * longest_edge_) return 0;
    const double sides = first + second + (to_second - to_first).sqrnorm();
    worst = std::min(worst, 2 * std::sqrt(3.0) * (to_first % to_second).norm() / sides);
    if (worst < least) return 0;
  }
  return worst;
}

double Decimation::worst_quality_towards(VertexHandle w, double least) const {
  double worst = 1;
  for (std::size_t f = 0; f < num_fans_; ++f) {
    const auto& rim = fans_[f].rim;
    const auto apex = std::find(rim.begin(), rim.end(), w) - rim.begin();
    worst = std::min(worst, worst_quality(fans_[f], static_cast<std::size_t>(apex), least));
  }
  return worst;
}

/// Returns the half-edge whose collapse leaves the best faces; an invalid handle if every choice is bad.
HalfedgeHandle Decimation::choose_collapse(VertexHandle v) {
  VertexHandle best;
  double best_quality = kWorstQuality;
  const auto consider = [&](VertexHandle w) {
    const double quality = worst_quality_towards(w, best_quality);
    if (quality > kClearly * best_quality) best = w, best_quality = quality;
  };
  if (is_free(v.idx())) {
    for (std::size_t i = 0; i + 1 < fans_[0].rim.size(); ++i) consider(fans_[0].rim[i]);
  } else {
    const VertexHandle ends[2] = {VertexHandle(wire_neighbors_[v.idx()][0]), VertexHandle(wire_neighbors_[v.idx()][1])};
    if (mesh_.find_halfedge(ends[0], ends[1]).is_valid()) return HalfedgeHandle();
    for (const VertexHandle w : ends) consider(w);
  }
  if (!best.is_valid()) return HalfedgeHandle();
  const HalfedgeHandle h = mesh_.find_halfedge(v, best);
  return mesh_.is_collapse_ok(h) ? h : HalfedgeHandle();
}

/// Moves the removed vertices of a fan into the faces that the fan has after v moved to w. If v is not on a wire, v
/// becomes a removed vertex, too.
void Decimation::move_points(const Fan& fan, VertexHandle v, VertexHandle w) {
  moved_.clear();
  moved_to_.clear();
  const auto position_of = [&](std::size_t face, int corner) -> Eigen::Vector2d {
    if (corner == v.idx()) return {0, 0};
    return fan.positions[corner == fan.rim[face].idx() ? face : face + 1];
  };
  for (std::size_t i = 0; i < fan.faces.size(); ++i) {
    const int f = fan.faces[i].idx();
    Eigen::Vector2d corners[3];
    for (int k = 0; k < 3; ++k) corners[k] = position_of(i, corners_[f][k]);
    for (int point = first_point_[f]; point != -1; point = places_[point].next) {
      const double* weights = places_[point].weights;
      moved_.push_back(point);
      moved_to_.push_back(weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2]);
    }
    first_point_[f] = -1;
  }
  if (is_free(v.idx())) {
    moved_.push_back(v.idx());
    moved_to_.push_back({0, 0});
  }
  const auto apex = static_cast<std::size_t>(std::find(fan.rim.begin(), fan.rim.end(), w) - fan.rim.begin());
  const Eigen::Vector2d a = fan.positions[apex];
  for (std::size_t m = 0; m < moved_.size(); ++m) {
    Place best;
    int best_face = -1;
    double most_inside = -1e300;
    for (std::size_t i = 0; i < fan.faces.size(); ++i) {
      if (fan.rim[i] == w || fan.rim[i + 1] == w) continue;
      const Eigen::Vector2d b = fan.positions[i] - a, c = fan.positions[i + 1] - a, p = moved_to_[m] - a;
      const double area = cross(b, c);
      const double to_b = cross(p, c) / area, to_c = cross(b, p) / area, to_a = 1 - to_b - to_c;
      const double inside = std::min({to_a, to_b, to_c});
      if (inside <= most_inside) continue;
      most_inside = inside;
      best_face = fan.faces[i].idx();
      for (int k = 0; k < 3; ++k) {
        const int corner = corners_[best_face][k];
        best.weights[k] = corner == v.idx() ? to_a : corner == fan.rim[i].idx() ? to_b : to_c;
      }
    }
    best.next = first_point_[best_face];
    first_point_[best_face] = moved_[m];
    places_[moved_[m]] = best;
    face_of_point_[moved_[m]] = best_face;
  }
  for (const FaceHandle face : fan.faces)
    std::replace(corners_[face.idx()].begin(), corners_[face.idx()].end(), v.idx(), w.idx());
}

bool Decimation::try_remove(VertexHandle v) {
  if (!lay_out_fans(v)) return false;
  const HalfedgeHandle h = choose_collapse(v);
  if (!h.is_valid()) return false;
  const VertexHandle w = mesh_.to_vertex_handle(h);
  for (std::size_t f = 0; f < num_fans_; ++f) {
    move_points(fans_[f], v, w);
    for (const VertexHandle neighbor : fans_[f].rim) is_locked_[neighbor.idx()] = 1;
  }
  if (!is_free(v.idx())) {
    const WireNeighbors ends = wire_neighbors_[v.idx()];
    std::replace(wire_neighbors_[ends[0]].begin(), wire_neighbors_[ends[0]].end(), v.idx(), ends[1]);
    std::replace(wire_neighbors_[ends[1]].begin(), wire_neighbors_[ends[1]].end(), v.idx(), ends[0]);
  }
  mesh_.collapse(h);
  return true;
}

int Decimation::remove_round() {
  std::fill(is_locked_.begin(), is_locked_.end(), 0);
  int removed = 0;
  for (const VertexHandle v : mesh_.vertices()) {
    if (!is_kept_[v.idx()] && !is_locked_[v.idx()]) removed += try_remove(v) ? 1 : 0;
  }
  return removed;
}

void Decimation::run(const StopToken& stop) {
  auto left = static_cast<double>(mesh_.n_vertices());
  for (double removed = left; removed > kWorthwhile * left; left -= removed) {
    stop.check();
    removed = remove_round();
  }
}

DecimatedMesh Decimation::result() {
  DecimatedMesh result;
  const std::size_t num_vertices = mesh_.n_vertices();
  OpenMesh::VPropHandleT<int> fine_vertex;
  mesh_.add_property(fine_vertex);
  for (const VertexHandle v : mesh_.all_vertices()) mesh_.property(fine_vertex, v) = v.idx();
  mesh_.garbage_collection();
  result.coarse_vertex.assign(num_vertices, -1);
  for (const VertexHandle v : mesh_.vertices()) {
    result.fine_vertex.push_back(mesh_.property(fine_vertex, v));
    result.coarse_vertex[result.fine_vertex.back()] = v.idx();
  }
  mesh_.remove_property(fine_vertex);
  result.places.resize(num_vertices);
  for (std::size_t v = 0; v < num_vertices; ++v) {
    CoarsePlace& place = result.places[v];
    const int coarse = result.coarse_vertex[v];
    place = {{coarse, coarse, coarse}, {1, 0, 0}};
    if (coarse != -1 || face_of_point_[v] == -1) continue;
    for (int k = 0; k < 3; ++k) {
      place.vertices[k] = result.coarse_vertex[corners_[face_of_point_[v]][k]];
      place.weights[k] = places_[v].weights[k];
    }
  }
  mesh_.release_vertex_status();
  mesh_.release_edge_status();
  mesh_.release_face_status();
  result.mesh = std::move(mesh_);
  return result;
}

}  // namespace

DecimatedMesh decimate(const Chart& chart, const HeldNetwork& network, double edge_length, const StopToken& stop) {
  Decimation decimation(chart, network, edge_length);
  decimation.run(stop);
  return decimation.result();
}

}  // namespace wirewarp
