// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/coarsen/unfold_slivers.h"

#include <cmath>
#include <utility>
#include <vector>

#include "energy/shape_error.h"

namespace wirewarp {
namespace {

constexpr double kThin = 0.3;    // largest determinant of a sliver's map; triangles of a good start have 0.7 to 1.3
constexpr double kStill = 0.01;  // shortest move that counts, over the mean edge; a third saves no Newton step
constexpr int kMaxSweeps = 100;  // sweeps over the moving vertices; 10 to 30 are usual

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

  /// Moves a vertex to the minimum of the shape error for fixed rotations of the triangles around it. This never
  /// increases the shape error. Returns the distance times the square root of the stiffness at the vertex.
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
  std::vector<char> is_out_;  // not added to the next sweep: already in it, or fixed
  std::vector<int> next_;
};

}  // namespace

void unfold_slivers(const Chart& chart, const HeldNetwork& network, Positions2& uv) {
  Slivers(chart, network, uv).unfold();
}

}  // namespace wirewarp
