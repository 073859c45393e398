// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/mesh/geodesic_distance.h"

#include <Eigen/SparseCore>
#include <algorithm>

#include "base/factorization_failed.h"
#include "numerics/cholesky/matrix_graph.h"
#include "surface/mesh/geometry.h"
#include "surface/mesh/project_to_principal_plane.h"

namespace wirewarp {
namespace {

/// Time of the flow, in squares of the mean edge length. Crane, Weischedel and Wardetzky use 1. With 4, the heat at the
/// far end of a million triangles is above the smallest double.
constexpr double kTime = 4;

/// The Laplacian L is singular. Therefore, this factor times the areas at vertices, divided by their mean, is added to
/// its diagonal. The distances change by less than this share.
constexpr double kShift = 1e-9;

using Point = HalfEdgeMesh::Point;

}  // namespace

GeodesicDistance::GeodesicDistance(const HalfEdgeMesh& mesh, const StopToken& stop)
    : mesh_(mesh), cotangents_(mesh.n_halfedges(), 0) {
  const auto n = static_cast<Eigen::Index>(mesh.n_vertices());
  Eigen::VectorXd mass = Eigen::VectorXd::Zero(n);
  std::vector<Eigen::Triplet<double>> entries;
  double length = 0;
  for (const EdgeHandle e : mesh.edges()) length += edge_length(mesh, mesh.halfedge_handle(e, 0));
  const double mean_length = length / static_cast<double>(mesh.n_edges());
  for (const HalfedgeHandle h : mesh.halfedges()) {
    if (mesh.is_boundary(h)) continue;
    const HalfedgeHandle opposite = mesh.prev_halfedge_handle(h);
    const Point apex = mesh.point(mesh.from_vertex_handle(opposite));
    const Point a = mesh.point(mesh.from_vertex_handle(h)) - apex, b = mesh.point(mesh.to_vertex_handle(h)) - apex;
    const double twice_area = (a % b).norm();
    cotangents_[h.idx()] = (a | b) / twice_area;
    mass[mesh.from_vertex_handle(h).idx()] += twice_area / 6;
    const auto [low, high] = std::minmax({mesh.from_vertex_handle(h).idx(), mesh.to_vertex_handle(h).idx()});
    const double weight = cotangents_[h.idx()] / 2;
    entries.emplace_back(high, low, -weight);
    entries.emplace_back(low, low, weight);
    entries.emplace_back(high, high, weight);
  }
  Eigen::SparseMatrix<double> laplacian(n, n), masses(n, n);
  laplacian.setFromTriplets(entries.begin(), entries.end());
  masses = Eigen::SparseMatrix<double>(mass.asDiagonal());
  const DissectionTree tree = nested_dissection(graph_of(laplacian, 1), project_to_principal_plane(points_of(mesh)));
  const auto factor = [&](const Eigen::SparseMatrix<double>& matrix) {
    auto cholesky = std::make_unique<MultifrontalCholesky>(matrix, tree, 1);
    const bool is_positive = cholesky->factorize(matrix, stop);
    if (stop.is_stopped()) throw Stopped();
    if (!is_positive) throw FactorizationFailed("geodesic_distance: the Laplacian has no factor");
    return cholesky;
  };
  heat_ = factor(masses + kTime * mean_length * mean_length * laplacian);
  poisson_ = factor(laplacian + kShift / mass.mean() * masses);
}

Eigen::VectorXd GeodesicDistance::from(VertexHandle source) const {
  Eigen::MatrixXd heat = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(mesh_.n_vertices()), 1);
  heat(source.idx(), 0) = 1;
  heat_->solve_in_place(heat);
  Eigen::MatrixXd distance = Eigen::MatrixXd::Zero(heat.rows(), 1);
  for (const FaceHandle f : mesh_.faces()) {
    const HalfedgeHandle sides[] = {mesh_.halfedge_handle(f), mesh_.next_halfedge_handle(mesh_.halfedge_handle(f)),
                                    mesh_.prev_halfedge_handle(mesh_.halfedge_handle(f))};
    Point vectors[3], gradient(0, 0, 0);
    for (int k = 0; k < 3; ++k) vectors[k] = mesh_.calc_edge_vector(sides[k]);
    const Point normal = vectors[0] % vectors[1];
    // Up to a positive factor, the gradient is a sum over the vertices: the heat of a vertex times the opposite side,
    // rotated to point into the triangle.
    for (int k = 0; k < 3; ++k)
      gradient += heat(mesh_.to_vertex_handle(sides[(k + 1) % 3]).idx(), 0) * (normal % vectors[k]);
    const double length = gradient.norm();
    if (!(length > 0)) continue;
    const Point uphill = gradient / -length;  // the direction in which the distance increases
    for (int k = 0; k < 3; ++k) {
      const double flow = cotangents_[sides[k].idx()] * (vectors[k] | uphill) / 2;
      distance(mesh_.to_vertex_handle(sides[k]).idx(), 0) += flow;
      distance(mesh_.from_vertex_handle(sides[k]).idx(), 0) -= flow;
    }
  }
  poisson_->solve_in_place(distance);
  return distance.col(0).array() - distance(source.idx(), 0);
}

}  // namespace wirewarp
