// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/coarsen/prolong.h"

#include <Eigen/Geometry>
#include <cmath>
#include <utility>
#include <vector>

#include "energy/shape_error.h"
#include "newton/coarsen/prolong_wires.h"
#include "surface/mesh/geometry.h"

namespace wirewarp {
namespace {

using Derivative = Eigen::Matrix<double, 2, 3>;

Eigen::Vector3d point(const HalfEdgeMesh& mesh, int v) { return vector_of(mesh.point(VertexHandle(v))); }

/// Returns the derivative J of the flat map at each vertex: the mean over the faces around it, weighted by area.
std::vector<Derivative> vertex_derivatives(const HalfEdgeMesh& mesh, const Positions2& uv) {
  std::vector<Derivative> sum(mesh.n_vertices(), Derivative::Zero());
  std::vector<double> area(mesh.n_vertices(), 0);
  const Triangles triangles = triangles_of(mesh);
  for (int f = 0; f < triangles.rows(); ++f) {
    const int a = triangles(f, 0), b = triangles(f, 1), c = triangles(f, 2);
    const Eigen::Vector3d ab = point(mesh, b) - point(mesh, a), ac = point(mesh, c) - point(mesh, a);
    const Eigen::Vector3d normal = ab.cross(ac);
    const double twice_area = normal.norm();
    // The rows of J are the gradients of the flat coordinates, computed from the gradients of the hat functions of b
    // and c.
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

constexpr double kThin = 0.3;    // largest determinant of a sliver's map; triangles of a good start have 0.7 to 1.3
constexpr double kStill = 0.01;  // shortest move that counts, in mean edge lengths; smaller values save no Newton step
constexpr int kMaxSweeps = 100;  // sweeps over the moving vertices; 10 to 30 are usual

/// Unfolds triangles that are flipped or nearly flipped. Fine meshes have slivers that are folded over their neighbors,
/// and a smooth map keeps these folds. Vertices of the network do not move.
class Slivers {
 public:
  Slivers(const Chart& chart, const HeldNetwork& network, Positions2& uv)
      : mesh_(chart.mesh), shape_error_(chart), uv_(uv), is_out_(mesh_.n_vertices(), 0) {
    for (const WireEdge& edge : network.edges) {
      const HalfedgeHandle h = mesh_.halfedge_handle(edge.edge, 0);
      for (const VertexHandle v : {mesh_.from_vertex_handle(h), mesh_.to_vertex_handle(h)}) is_out_[v.idx()] = 1;
    }
  }

  void unfold() {
    double area = 0;
    for (const ShapeError::Triangle& t : shape_error_.triangles()) {
      area += t.area;
      if (ShapeError::map_of(t, uv_).determinant() < kThin) add_vertices(t);
    }
    const double still = kStill * std::sqrt(area / static_cast<double>(mesh_.n_faces()));
    for (int sweep = 0; sweep < kMaxSweeps && !next_.empty(); ++sweep) {
      const std::vector<int> vertices = std::exchange(next_, {});
      for (const int v : vertices) is_out_[v] = 0;
      for (const int v : vertices) {
        if (move(v) < still) continue;
        for (const FaceHandle f : mesh_.vf_range(VertexHandle(v))) add_vertices(shape_error_.triangles()[f.idx()]);
      }
    }
  }

 private:
  void add_vertices(const ShapeError::Triangle& t) {
    for (const int v : t.vertices) {
      if (!std::exchange(is_out_[v], 1)) next_.push_back(v);
    }
  }

  /// Moves a vertex to the minimum of the shape error for fixed rotations around it. This never increases the shape
  /// error. Returns the distance times the square root of the stiffness.
  double move(int v) {
    Eigen::Vector2d gradient(0, 0);
    double stiffness = 0;
    for (const FaceHandle f : mesh_.vf_range(VertexHandle(v))) {
      const ShapeError::Triangle& t = shape_error_.triangles()[f.idx()];
      const ShapeError::LinearMap map = ShapeError::map_of(t, uv_);
      if (!(map.norm_z > 0)) continue;
      const int corner = t.vertices[0] == v ? 0 : t.vertices[1] == v ? 1 : 2;
      const Eigen::Vector2d hat = t.hat_gradients().col(corner);
      const double c = map.z1 / map.norm_z, s = map.z2 / map.norm_z;
      const Eigen::Matrix2d rotation = (Eigen::Matrix2d() << c, -s, s, c).finished();
      gradient += 2 * t.area * (map.matrix() - rotation) * hat;
      stiffness += 2 * t.area * hat.squaredNorm();
    }
    if (!(stiffness > 0)) return 0;
    uv_.row(v) -= gradient.transpose() / stiffness;
    return gradient.norm() / std::sqrt(stiffness);
  }

  const HalfEdgeMesh& mesh_;
  const ShapeError shape_error_;
  Positions2& uv_;
  std::vector<char> is_out_;  // vertices that are fixed or already in the next sweep
  std::vector<int> next_;
};

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
  Slivers(chart, network, uv).unfold();
  return uv;
}

Eigen::VectorXd prolong_multipliers(const CoarseChart& coarse, const Eigen::VectorXd& coarse_multipliers) {
  Eigen::VectorXd fine(static_cast<Eigen::Index>(coarse.wire_places.size()));
  for (int e = 0; e < fine.size(); ++e) fine[e] = coarse_multipliers[coarse.wire_places[e].edge];
  return fine;
}

}  // namespace wirewarp
