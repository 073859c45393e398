// SPDX-License-Identifier: GPL-3.0-or-later
#include "cuts/feasibility/bisect.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "base/disjoint_sets.h"
#include "surface/mesh/geometry.h"
#include "surface/mesh/principal_axes.h"
#include "surface/mesh/shortest_paths.h"

namespace wirewarp {
namespace {

using Sides = std::vector<char>;  // 0 or 1 per face

/// Length of each edge, in scene units. Forbidden edges have an infinite length, so that the border between the sides
/// avoids them.
using Prices = std::vector<double>;

Prices prices_of(const HalfEdgeMesh& mesh, const CutMask& forbidden) {
  Prices prices;
  for (const EdgeHandle e : mesh.edges()) {
    const double length = edge_length(mesh, mesh.halfedge_handle(e, 0));
    prices.push_back(forbidden[e.idx()] != 0 ? std::numeric_limits<double>::infinity() : length);
  }
  return prices;
}

VertexHandle farthest_from(const HalfEdgeMesh& mesh, const std::vector<VertexHandle>& sources) {
  return farthest_vertex(shortest_paths(mesh, sources));
}

VertexHandle far_end(const HalfEdgeMesh& mesh) {
  const std::vector<VertexHandle> boundary = boundary_vertices(mesh);
  return farthest_from(mesh, boundary.empty() ? std::vector<VertexHandle>{VertexHandle(0)} : boundary);
}

bool is_border(const HalfEdgeMesh& mesh, const Sides& side, HalfedgeHandle h) {
  if (mesh.is_boundary(mesh.edge_handle(h))) return false;
  return side[mesh.face_handle(h).idx()] != side[mesh.opposite_face_handle(h).idx()];
}

/// Returns by how many scene units the border becomes longer if all faces around a vertex move to the side `to`.
double growth_of_border(const HalfEdgeMesh& mesh, const Prices& prices, const Sides& side, VertexHandle v, char to) {
  const auto price = [&](HalfedgeHandle h) { return prices[mesh.edge_handle(h).idx()]; };
  double growth = 0;
  for (const HalfedgeHandle spoke : mesh.voh_range(v)) {
    if (is_border(mesh, side, spoke)) growth -= price(spoke);
    if (mesh.is_boundary(spoke) || side[mesh.face_handle(spoke).idx()] == to) continue;
    const HalfedgeHandle rim = mesh.next_halfedge_handle(spoke);
    if (mesh.is_boundary(mesh.edge_handle(rim))) continue;
    growth += is_border(mesh, side, rim) ? -price(rim) : price(rim);
  }
  return growth;
}

/// Moves the border across one vertex after another, as long as each move makes the border shorter.
void shorten_border(const HalfEdgeMesh& mesh, const Prices& prices, Sides& side) {
  constexpr double kRounding = 1e-12;  // decreases below this share of the vertex's longest edge are rounding errors
  std::vector<VertexHandle> queue(mesh.vertices_begin(), mesh.vertices_end());
  while (!queue.empty()) {
    const VertexHandle v = queue.back();
    queue.pop_back();
    double longest = 0;
    for (const HalfedgeHandle spoke : mesh.voh_range(v)) longest = std::max(longest, edge_length(mesh, spoke));
    for (const char to : {char{0}, char{1}}) {
      if (growth_of_border(mesh, prices, side, v, to) >= -kRounding * longest) continue;
      for (const FaceHandle f : mesh.vf_range(v)) side[f.idx()] = to;
      for (const VertexHandle near : mesh.vv_range(v)) queue.push_back(near);
    }
  }
}

/// Distances of a face from two vertices count as equal if they differ by less than this share of the distance between
/// the vertices. So rounding errors do not choose sides.
constexpr double kSameDistance = 1e-9;

/// Returns 1 for each face that is clearly nearer to the second vertex than to the first, otherwise 0.
Sides nearer_to(const HalfEdgeMesh& mesh, VertexHandle first, VertexHandle second) {
  const std::vector<double> from_first = shortest_paths(mesh, {first}).distance;
  const std::vector<double> from_second = shortest_paths(mesh, {second}).distance;
  const double same = kSameDistance * from_first[second.idx()];
  Sides side(mesh.n_faces(), 0);
  for (const FaceHandle f : mesh.faces()) {
    double lead = 0;
    for (const VertexHandle v : mesh.fv_range(f)) lead += from_first[v.idx()] - from_second[v.idx()];
    side[f.idx()] = lead > same;
  }
  return side;
}

struct FaceGeometry {
  explicit FaceGeometry(const HalfEdgeMesh& mesh) {
    const Positions3 points = points_of(mesh);
    const Triangles triangles = triangles_of(mesh);
    middle.resize(triangles.rows(), 3);
    area.resize(triangles.rows(), 3);
    for (int f = 0; f < triangles.rows(); ++f) {
      const Eigen::Vector3d a = points.row(triangles(f, 0)), b = points.row(triangles(f, 1)),
                            c = points.row(triangles(f, 2));
      middle.row(f) = (a + b + c) / 3;
      area.row(f) = (b - a).cross(c - a) / 2;
    }
  }
  Positions3 middle, area;  // per face: centroid; normal with the face's area as length
};

/// Returns 1 for each face that is clearly on one side of the middle, otherwise 0. As the direction of the axis is
/// arbitrary, this is the side of the first face that is clearly off the middle. along: position of each face on the
/// axis.
Sides sides_along(Eigen::VectorXd along) {
  // This tolerance covers the small rotation of axes that principal_axes() allows.
  const double middle = 1e-5 * along.cwiseAbs().maxCoeff();
  const auto first = std::find_if(along.begin(), along.end(), [&](double place) { return std::abs(place) > middle; });
  if (first != along.end() && *first < 0) along = -along;
  Sides side;
  for (const double place : along) side.push_back(place > middle);
  return side;
}

/// Returns divisions of the faces: by planes perpendicular to the principal axes, then into front and back as seen
/// along these axes.
std::vector<Sides> sides_of_axes(const HalfEdgeMesh& mesh) {
  const FaceGeometry faces(mesh);
  const Eigen::VectorXd areas = faces.area.rowwise().norm();
  const Eigen::RowVector3d middle = areas.transpose() * faces.middle / areas.sum();
  const Positions3 from_middle = faces.middle.rowwise() - middle;
  const Eigen::Matrix3d spread = from_middle.transpose() * areas.asDiagonal() * from_middle;
  const Eigen::Matrix3d axes = principal_axes(mesh, spread);
  std::vector<Sides> result;
  for (const Positions3& vectors : {from_middle, faces.area}) {
    for (int axis = 0; axis < 3; ++axis) {
      result.push_back(sides_along(vectors * axes.col(axis)));
    }
  }
  return result;
}

std::vector<Sides> sides_of_ends(const HalfEdgeMesh& mesh) {
  const VertexHandle first = far_end(mesh);
  const VertexHandle second = farthest_from(mesh, {first});
  const VertexHandle third = farthest_from(mesh, {first, second});
  const VertexHandle fourth = farthest_from(mesh, {third});
  return {nearer_to(mesh, first, second), nearer_to(mesh, third, fourth)};
}

/// Faces that share forbidden edges form a group. Moves each group to the side that has most of its faces.
void keep_together(const HalfEdgeMesh& mesh, const CutMask& forbidden, Sides& side) {
  DisjointSets groups(mesh.n_faces());
  for (const EdgeHandle e : mesh.edges()) {
    const HalfedgeHandle h = mesh.halfedge_handle(e, 0);
    if (forbidden[e.idx()] == 0 || mesh.is_boundary(e)) continue;
    groups.unite(mesh.face_handle(h).idx(), mesh.opposite_face_handle(h).idx());
  }
  int count = 0;
  const std::vector<int> group = groups.number(count);
  std::vector<int> lead(static_cast<std::size_t>(count), 0);
  for (std::size_t f = 0; f < side.size(); ++f) lead[group[f]] += side[f] != 0 ? 1 : -1;
  for (std::size_t f = 0; f < side.size(); ++f) side[f] = lead[group[f]] > 0;
}

CutMask cut_along_border(const HalfEdgeMesh& mesh, const Sides& side) {
  CutMask cut(mesh.n_edges(), 0);
  for (const EdgeHandle e : mesh.edges()) cut[e.idx()] = is_border(mesh, side, mesh.halfedge_handle(e, 0));
  return cut;
}

}  // namespace

std::vector<CutMask> bisections(const HalfEdgeMesh& mesh, const CutMask& forbidden) {
  const Prices prices = prices_of(mesh, forbidden);
  std::vector<Sides> all_sides = sides_of_axes(mesh);
  for (Sides& side : sides_of_ends(mesh)) all_sides.push_back(std::move(side));
  std::vector<CutMask> cuts;
  const auto add = [&](const Sides& side) {
    CutMask cut = cut_along_border(mesh, side);
    const bool is_known = std::find(cuts.begin(), cuts.end(), cut) != cuts.end();
    if (!is_known && length_of_cut(mesh, cut) > 0) cuts.push_back(std::move(cut));
  };
  // On a coarse mesh, shortening may reduce a border to nothing, so the original border is added, too. On fine meshes,
  // original borders are jagged: without the limit kCoarse, 43 models have 154 pieces in total, not 93.
  // Half or twice the limit changes no test of proposed seams.
  constexpr std::size_t kCoarse = 1000;
  for (Sides& side : all_sides) {
    keep_together(mesh, forbidden, side);
    const Sides as_drawn = side;
    shorten_border(mesh, prices, side);
    add(side);
    if (mesh.n_faces() < kCoarse) add(as_drawn);
  }
  return cuts;
}

}  // namespace wirewarp
