// SPDX-License-Identifier: GPL-3.0-or-later
#include "cuts/parts/crease_lines.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <utility>
#include <vector>

#include "base/factorization_failed.h"
#include "base/planar.h"
#include "surface/mesh/geometry.h"

namespace wirewarp {
namespace {

/// The band around a loop extends this many radii of the loop towards the limb's tip and towards the body. If the
/// limb's axis meets the body at 45 degrees, the whole crease is at most two radii from the loop. Towards the tip, one
/// radius is enough, because lines widen at the crease.
constexpr double kTowardsTip = 1, kTowardsBody = 2;

/// The conductance of an edge is halved if its concave curvature times the loop's radius equals kConcave. For much
/// larger curvatures, the conductance falls with the square of the curvature. A fillet with twice the loop's radius has
/// this curvature, and wider fillets do not look like a crease.
constexpr double kConcave = 0.5;

/// Number of times that each normal is averaged with the normals of the neighboring vertices. Without averaging, lines
/// in the shallow creases of a star follow single edges.
constexpr int kSmoothings = 2;

using Point = HalfEdgeMesh::Point;

std::vector<Point> smooth_normals(const HalfEdgeMesh& mesh) {
  std::vector<Point> normals(mesh.n_vertices(), Point(0, 0, 0));
  for (const HalfedgeHandle h : mesh.halfedges()) {
    const Point normal = mesh.calc_edge_vector(mesh.prev_halfedge_handle(h)) % mesh.calc_edge_vector(h);
    normals[static_cast<std::size_t>(mesh.from_vertex_handle(h).idx())] += normal;
  }
  for (Point& normal : normals) normal.normalize();
  for (int i = 0; i < kSmoothings; ++i) {
    std::vector<Point> sums = normals;
    for (const HalfedgeHandle h : mesh.halfedges()) {
      const auto from = static_cast<std::size_t>(mesh.from_vertex_handle(h).idx());
      sums[from] += normals[static_cast<std::size_t>(mesh.to_vertex_handle(h).idx())];
    }
    for (Point& normal : sums) normal.normalize();
    normals = std::move(sums);
  }
  return normals;
}

}  // namespace

Eigen::VectorXd potential_across(const HalfEdgeMesh& mesh, const Eigen::VectorXd& distance, double level,
                                 double length) {
  const double radius = length / (2 * kPi);
  std::vector<int> unknown_of(mesh.n_vertices(), -1);
  Eigen::VectorXd potential(distance.size());
  int count = 0;
  for (Eigen::Index v = 0; v < distance.size(); ++v) {
    const double place = (distance[v] - level) / radius;
    potential[v] = place <= -kTowardsTip ? 0 : 1;
    if (place > -kTowardsTip && place < kTowardsBody) unknown_of[static_cast<std::size_t>(v)] = count++;
  }
  const std::vector<Point> normals = smooth_normals(mesh);
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd flow = Eigen::VectorXd::Zero(count);
  for (const HalfedgeHandle h : mesh.halfedges()) {
    const VertexHandle from = mesh.from_vertex_handle(h), to = mesh.to_vertex_handle(h);
    const int row = unknown_of[static_cast<std::size_t>(from.idx())];
    if (row < 0) continue;
    const Point along = mesh.calc_edge_vector(h);
    const Point bend = normals[static_cast<std::size_t>(to.idx())] - normals[static_cast<std::size_t>(from.idx())];
    const double square = along.sqrnorm(), concave = std::max(0.0, -(bend | along) / square) * radius / kConcave;
    const double area =
        face_area(mesh, mesh.face_handle(h)) + face_area(mesh, mesh.face_handle(mesh.opposite_halfedge_handle(h)));
    const double weight = area / square / (1 + concave * concave);
    entries.emplace_back(row, row, weight);
    const int column = unknown_of[static_cast<std::size_t>(to.idx())];
    if (column >= 0) {
      entries.emplace_back(row, column, -weight);
    } else {
      flow[row] += weight * potential[to.idx()];
    }
  }
  Eigen::SparseMatrix<double> conductances(count, count);
  conductances.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(conductances);
  if (factor.info() != Eigen::Success) throw FactorizationFailed("crease_lines: the conductances have no factor");
  const Eigen::VectorXd inside = factor.solve(flow);
  for (std::size_t v = 0; v < unknown_of.size(); ++v) {
    if (unknown_of[v] >= 0) potential[static_cast<Eigen::Index>(v)] = inside[unknown_of[v]];
  }
  return potential;
}

}  // namespace wirewarp
