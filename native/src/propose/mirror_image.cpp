// SPDX-License-Identifier: GPL-3.0-or-later
#include "propose/mirror_image.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "mesh/geometry.h"

namespace wirewarp {
namespace {

constexpr double kSame =
    1e-4;  // over the root of the area: meshes of single precision, modeled in halves, keep to that

/// Vertices by their place along a direction, so that those at one point are near each other.
class VerticesInOrder {
 public:
  VerticesInOrder(const Positions3& points, const Eigen::Vector3d& direction)
      : points_(points), along_(points * direction), order_(static_cast<std::size_t>(points.rows())) {
    std::iota(order_.begin(), order_.end(), 0);
    std::sort(order_.begin(), order_.end(), [&](int a, int b) { return along_[a] < along_[b]; });
  }

  /// The nearest within a distance; -1 if none is.
  int at(const Eigen::RowVector3d& point, double along, double distance) const {
    const auto first = std::lower_bound(order_.begin(), order_.end(), along - distance,
                                        [&](int v, double bound) { return along_[v] < bound; });
    int nearest = -1;
    for (auto it = first; it != order_.end() && along_[*it] <= along + distance; ++it) {
      const double apart = (points_.row(*it) - point).norm();
      if (apart > distance) continue;
      distance = apart;
      nearest = *it;
    }
    return nearest;
  }

 private:
  const Positions3& points_;
  Eigen::VectorXd along_;
  std::vector<int> order_;
};

}  // namespace

std::vector<VertexHandle> mirror_image(const Chart& chart) {
  Positions3 points = points_of(chart.mesh);
  const Eigen::RowVector3d center = points.colwise().mean();
  points.rowwise() -= center;
  const double tolerance = kSame * std::sqrt(surface_area(chart.mesh));
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> spread(points.transpose() * points);
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d normal = spread.eigenvectors().col(k), across = spread.eigenvectors().col((k + 1) % 3);
    if ((points * normal).cwiseAbs().maxCoeff() < tolerance) continue;  // a flat piece lies in this plane
    const VerticesInOrder in_order(points, across);
    std::vector<VertexHandle> image;
    for (Eigen::Index v = 0; v < points.rows(); ++v) {
      const Eigen::RowVector3d opposite = points.row(v) - 2 * points.row(v).dot(normal) * normal.transpose();
      const int found = in_order.at(opposite, opposite.dot(across), tolerance);
      if (found < 0) break;
      image.push_back(VertexHandle(found));
    }
    if (static_cast<Eigen::Index>(image.size()) == points.rows()) return image;
  }
  return {};
}

HalfEdgeChain mirrored(const Chart& chart, const std::vector<VertexHandle>& image, const HalfEdgeChain& chain) {
  HalfEdgeChain result;
  for (const HalfedgeHandle h : chain) {
    const HalfedgeHandle opposite = chart.mesh.find_halfedge(image[chart.mesh.from_vertex_handle(h).idx()],
                                                             image[chart.mesh.to_vertex_handle(h).idx()]);
    if (!opposite.is_valid() || chart.mesh.is_boundary(chart.mesh.edge_handle(opposite))) return {};
    result.push_back(opposite);
  }
  return result;
}

}  // namespace wirewarp
