// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/unfold.h"

#include <cmath>
#include <queue>
#include <utility>
#include <vector>

#include "energy/shape_error.h"
#include "surface/mesh/geometry.h"

namespace wirewarp {
namespace {

/// Largest root mean square strain of an unfolded chart. Coordinates rounded to four digits cause this strain, and
/// Newton steps correct it.
constexpr double kMostStrain = 1e-4;

/// A side at which a face can be placed. Longer sides come first, because rounding errors at a short side move all
/// faces beyond it. Sides of similar length come in the order found.
struct OpenSide {
  OpenSide(double length, int place, HalfedgeHandle h) : magnitude(std::ilogb(length)), rank(place), half_edge(h) {}
  bool operator<(const OpenSide& other) const {
    return std::make_pair(magnitude, -rank) < std::make_pair(other.magnitude, -other.rank);
  }

  int magnitude;  // exponent of 2 in the length
  int rank;
  HalfedgeHandle half_edge;
};

/// Returns the place of the third vertex of the face on the left of h, measured from the end of h that is nearer to the
/// vertex. Both ends must be placed already.
Eigen::RowVector2d opposite_place(const HalfEdgeMesh& mesh, HalfedgeHandle h, const Positions2& uv) {
  const VertexHandle a = mesh.from_vertex_handle(h), b = mesh.to_vertex_handle(h);
  const VertexHandle c = mesh.to_vertex_handle(mesh.next_halfedge_handle(h));
  const OpenMesh::Vec3d edge = mesh.point(b) - mesh.point(a);
  const OpenMesh::Vec3d from_a = mesh.point(c) - mesh.point(a), from_b = mesh.point(c) - mesh.point(b);
  const bool is_nearer_a = from_a.sqrnorm() <= from_b.sqrnorm();
  const OpenMesh::Vec3d& side = is_nearer_a ? from_a : from_b;
  const Eigen::RowVector2d along = (uv.row(b.idx()) - uv.row(a.idx())).normalized(), across(-along.y(), along.x());
  return uv.row((is_nearer_a ? a : b).idx()) + ((side | edge) * along + (side % edge).norm() * across) / edge.norm();
}

HalfedgeHandle longest_side(const HalfEdgeMesh& mesh, FaceHandle face) {
  HalfedgeHandle longest = mesh.halfedge_handle(face);
  for (const HalfedgeHandle h : mesh.fh_range(face)) {
    if (edge_length(mesh, h) > edge_length(mesh, longest)) longest = h;
  }
  return longest;
}

}  // namespace

std::optional<Shape> unfold(const Chart& chart) {
  const HalfEdgeMesh& mesh = chart.mesh;
  const ShapeError shape_error(chart);
  const double most_energy = kMostStrain * kMostStrain * surface_area(mesh);
  double energy = 0;
  Positions2 uv = Positions2::Zero(static_cast<Eigen::Index>(mesh.n_vertices()), 2);
  std::vector<char> has_place(mesh.n_vertices(), 0), is_laid(mesh.n_faces(), 0);

  const HalfedgeHandle first = longest_side(mesh, FaceHandle(0));
  uv(mesh.to_vertex_handle(first).idx(), 0) = edge_length(mesh, first);
  has_place[mesh.from_vertex_handle(first).idx()] = has_place[mesh.to_vertex_handle(first).idx()] = 1;
  std::priority_queue<OpenSide> sides;
  int num_sides = 0;
  const auto add_side = [&](HalfedgeHandle h) { sides.emplace(edge_length(mesh, h), num_sides++, h); };
  add_side(first);
  while (!sides.empty() && energy <= most_energy) {
    const HalfedgeHandle side = sides.top().half_edge;
    const FaceHandle face = mesh.face_handle(side);
    sides.pop();
    if (is_laid[face.idx()]) continue;
    is_laid[face.idx()] = 1;
    const int opposite = mesh.to_vertex_handle(mesh.next_halfedge_handle(side)).idx();
    if (!has_place[opposite]) uv.row(opposite) = opposite_place(mesh, side, uv);
    has_place[opposite] = 1;
    const ShapeError::Triangle& triangle = shape_error.triangles()[face.idx()];
    energy += triangle.area * ShapeError::map_of(triangle, uv).squared_distance_from_rotation();
    for (const HalfedgeHandle h : mesh.fh_range(face)) {
      const HalfedgeHandle across = mesh.opposite_halfedge_handle(h);
      if (!mesh.is_boundary(across) && !is_laid[mesh.face_handle(across).idx()]) add_side(across);
    }
  }
  if (energy > most_energy) return std::nullopt;
  return Shape{std::move(uv)};
}

}  // namespace wirewarp
