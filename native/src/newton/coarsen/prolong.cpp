// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/coarsen/prolong.h"

#include <Eigen/Geometry>

#include "newton/coarsen/prolong_wires.h"
#include "newton/coarsen/unfold_slivers.h"
#include "surface/mesh/geometry.h"

namespace wirewarp {
namespace {

using Derivative = Eigen::Matrix<double, 2, 3>;

Eigen::Vector3d point(const HalfEdgeMesh& mesh, int v) {
  const auto p = mesh.point(VertexHandle(v));
  return {p[0], p[1], p[2]};
}

/// Returns J at each vertex: the mean over its faces, weighted by area.
std::vector<Derivative> vertex_derivatives(const HalfEdgeMesh& mesh, const Positions2& uv) {
  std::vector<Derivative> sum(mesh.n_vertices(), Derivative::Zero());
  std::vector<double> area(mesh.n_vertices(), 0);
  const Triangles triangles = triangles_of(mesh);
  for (int f = 0; f < triangles.rows(); ++f) {
    const int a = triangles(f, 0), b = triangles(f, 1), c = triangles(f, 2);
    const Eigen::Vector3d ab = point(mesh, b) - point(mesh, a), ac = point(mesh, c) - point(mesh, a);
    const Eigen::Vector3d normal = ab.cross(ac);
    const double twice_area = normal.norm();
    // The rows of J are ∇u, from the gradients of the hat functions of b and c.
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
  unfold_slivers(chart, network, uv);
  return uv;
}

Eigen::VectorXd prolong_multipliers(const CoarseChart& coarse, const Eigen::VectorXd& coarse_multipliers) {
  Eigen::VectorXd fine(static_cast<Eigen::Index>(coarse.wire_places.size()));
  for (int e = 0; e < fine.size(); ++e) fine[e] = coarse_multipliers[coarse.wire_places[e].edge];
  return fine;
}

}  // namespace wirewarp
