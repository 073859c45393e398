// SPDX-License-Identifier: GPL-3.0-or-later
#include "coarsen/prolong.h"

#include <Eigen/Geometry>

#include "arap/shape_error.h"
#include "coarsen/prolong_wires.h"
#include "mesh/geometry.h"

namespace wirewarp {
namespace {

constexpr int kStepsOfARound = 10;    // reach ten edges far, coarse edges are about four
constexpr int kMostRounds = 5;        // beyond, curved panels take no factorization less
constexpr double kWorthwhile = 0.01;  // drop of a round over E: smooth sheets take two rounds

using Derivative = Eigen::Matrix<double, 2, 3>;

Eigen::Vector3d point(const HalfEdgeMesh& mesh, int v) {
  const auto p = mesh.point(VertexHandle(v));
  return {p[0], p[1], p[2]};
}

/// J around each vertex, the mean by area over its faces.
std::vector<Derivative> vertex_derivatives(const HalfEdgeMesh& mesh, const Positions2& uv) {
  std::vector<Derivative> sum(mesh.n_vertices(), Derivative::Zero());
  std::vector<double> area(mesh.n_vertices(), 0);
  const Triangles triangles = triangles_of(mesh);
  for (int f = 0; f < triangles.rows(); ++f) {
    const int a = triangles(f, 0), b = triangles(f, 1), c = triangles(f, 2);
    const Eigen::Vector3d ab = point(mesh, b) - point(mesh, a), ac = point(mesh, c) - point(mesh, a);
    const Eigen::Vector3d normal = ab.cross(ac);
    const double twice_area = normal.norm();
    // Rows of J: ∇u, with ∇ of the hats of b and c.
    const Eigen::Vector3d grad_b = ac.cross(normal) / (twice_area * twice_area);
    const Eigen::Vector3d grad_c = normal.cross(ab) / (twice_area * twice_area);
    const Derivative j = (uv.row(b) - uv.row(a)).transpose() * grad_b.transpose() +
                         (uv.row(c) - uv.row(a)).transpose() * grad_c.transpose();
    for (const int v : {a, b, c}) {
      sum[v] += twice_area * j;
      area[v] += twice_area;
    }
  }
  for (std::size_t v = 0; v < sum.size(); ++v) sum[v] /= area[v];
  return sum;
}

double dot(const Positions2& a, const Positions2& b) { return (a.array() * b.array()).sum(); }

/// Local/global steps of the shape error E over all vertices that no wire holds. The local step finds the rotations,
/// and with them the gradient. The global step lowers a quadratic that is nowhere below E: a few steps of conjugate
/// gradients, for what is wrong has short waves. Only where triangles have turned over: elsewhere the Newton steps take
/// as few factorizations without.
void smooth(const Chart& chart, const HeldNetwork& network, Positions2& uv) {
  const ShapeError shape_error(chart);
  if (shape_error.count_flips(uv) == 0) return;
  const Eigen::SparseMatrix<double> hessian = shape_error.fixed_rotation_hessian();
  Eigen::VectorXd preconditioner = hessian.diagonal().cwiseInverse();
  for (const WireEdge& edge : network.edges) {  // where it is 0 nothing moves
    const HalfedgeHandle h = chart.mesh.halfedge_handle(edge.edge, 0);
    preconditioner[chart.mesh.from_vertex_handle(h).idx()] = preconditioner[chart.mesh.to_vertex_handle(h).idx()] = 0;
  }
  Positions2 gradient;
  double energy = shape_error.energy_and_gradient(uv, gradient), drop = energy;
  for (int i = 0; i < kMostRounds && drop > kWorthwhile * energy; ++i) {
    Positions2 residual = -gradient, direction = preconditioner.asDiagonal() * residual;
    double size = dot(residual, direction);
    for (int k = 0; k < kStepsOfARound && size > 0; ++k) {
      const Positions2 product = hessian.selfadjointView<Eigen::Lower>() * direction;
      const double length = size / dot(direction, product);
      uv += length * direction;
      residual -= length * product;
      const Positions2 next = preconditioner.asDiagonal() * residual;
      const double next_size = dot(residual, next);
      direction = next + next_size / size * direction;
      size = next_size;
    }
    const double lower = shape_error.energy_and_gradient(uv, gradient);
    drop = energy - lower;
    energy = lower;
  }
}

}  // namespace

Positions2 interpolate(const Chart& chart, const CoarseChart& coarse, const Positions2& coarse_uv) {
  const std::vector<Derivative> derivatives = vertex_derivatives(coarse.chart.mesh, coarse_uv);
  Positions2 uv(static_cast<Eigen::Index>(chart.mesh.n_vertices()), 2);
  for (int v = 0; v < uv.rows(); ++v) {
    const CoarsePlace& place = coarse.places[v];
    const Eigen::Vector3d p = point(chart.mesh, v);
    Eigen::Vector2d u(0, 0);
    Derivative mean = Derivative::Zero();
    Eigen::Vector3d foot(0, 0, 0);
    for (int k = 0; k < 3; ++k) {
      const int i = place.vertices[k];
      const double b = place.weights[k];
      const Eigen::Vector3d corner = point(coarse.chart.mesh, i);
      u += b * (coarse_uv.row(i).transpose() + 0.5 * derivatives[i] * (p - corner));
      mean += b * derivatives[i];
      foot += b * corner;
    }
    uv.row(v) = (u + 0.5 * mean * (p - foot)).transpose();
  }
  return uv;
}

Positions2 prolong_positions(const Chart& chart, const HeldNetwork& network, const CoarseChart& coarse,
                             const Positions2& coarse_uv) {
  Positions2 uv = interpolate(chart, coarse, coarse_uv);
  prolong_wires(chart, network, coarse, coarse_uv, uv);
  smooth(chart, network, uv);
  return uv;
}

Eigen::VectorXd prolong_multipliers(const CoarseChart& coarse, const Eigen::VectorXd& coarse_multipliers) {
  Eigen::VectorXd fine(static_cast<Eigen::Index>(coarse.wire_places.size()));
  for (int e = 0; e < fine.size(); ++e) fine[e] = coarse_multipliers[coarse.wire_places[e].edge];
  return fine;
}

}  // namespace wirewarp
