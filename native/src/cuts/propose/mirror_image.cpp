// SPDX-License-Identifier: GPL-3.0-or-later
#include "cuts/propose/mirror_image.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "surface/mesh/geometry.h"

namespace wirewarp {
namespace {

/// Largest distance, over √area, between the mirrored position of a vertex and the vertex that is its image. Meshes in
/// single precision that were modeled with a mirror are symmetric to this precision.
constexpr double kSamePlace = 1e-4;

/// Lengths that differ by less than this factor count as equal, so that rotating the mesh does not change the choice of
/// the plane.
constexpr double kClearlyLonger = 1 + 1e-9;

/// Largest number of planes that are compared: a surface of revolution has more, but all are alike.
constexpr int kMostPlanes = 16;

/// Vertices sorted along one direction, to find the vertices near a point.
class VerticesInOrder {
 public:
  explicit VerticesInOrder(const Positions3& points)
      : points_(points), along_(points * direction()), order_(static_cast<std::size_t>(points.rows())) {
    std::iota(order_.begin(), order_.end(), 0);
    std::sort(order_.begin(), order_.end(), [&](int a, int b) { return along_[a] < along_[b]; });
  }

  /// Returns the vertex nearest to a point; -1 if no vertex is within the given distance.
  int at(const Eigen::RowVector3d& point, double distance) const {
    const double along = point.dot(direction());
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
  /// A direction along which few vertices of a mesh have the same position.
  static Eigen::Vector3d direction() { return Eigen::Vector3d(1, 0.618, 0.414).normalized(); }

  const Positions3& points_;
  Eigen::VectorXd along_;
  std::vector<int> order_;
};

/// Searches for planes through the center that mirror a surface onto itself.
class MirrorSearch {
 public:
  explicit MirrorSearch(const Chart& chart)
      : mesh_(chart.mesh), points_(centered(points_of(chart.mesh))), in_order_(points_) {
    tolerance_ = kSamePlace * std::sqrt(surface_area(mesh_));
  }

  /// Returns the image by the mirror plane that contains the greatest length of edges. Each tried plane mirrors a
  /// corner of the first face to another vertex, because no useful plane contains all three corners.
  std::vector<VertexHandle> best_image(const StopToken& stop) const {
    std::vector<VertexHandle> best;
    double longest = -1;
    int planes_left = kMostPlanes;
    for (const VertexHandle corner : mesh_.fv_range(FaceHandle(0))) {
      const Eigen::RowVector3d from = points_.row(corner.idx());
      for (Eigen::Index v = 0; v < points_.rows() && planes_left > 0; ++v) {
        const Eigen::RowVector3d apart = points_.row(v) - from;
        const bool is_as_far = std::abs(points_.row(v).norm() - from.norm()) < tolerance_;
        if (!is_as_far || apart.norm() < tolerance_) continue;
        stop.check();
        std::vector<VertexHandle> image = across(apart.normalized());
        if (image.empty()) continue;
        --planes_left;
        const double length = length_in_plane(image);
        if (length <= kClearlyLonger * longest) continue;
        longest = length;
        best = std::move(image);
      }
    }
    return best;
  }

  std::vector<VertexHandle> across(const Eigen::RowVector3d& normal) const {
    std::vector<VertexHandle> image;
    for (Eigen::Index v = 0; v < points_.rows(); ++v) {
      const Eigen::RowVector3d opposite = points_.row(v) - 2 * points_.row(v).dot(normal) * normal;
      const int found = in_order_.at(opposite, tolerance_);
      if (found < 0) return {};
      image.push_back(VertexHandle(found));
    }
    return image;
  }

 private:
  static Positions3 centered(Positions3 points) {
    const Eigen::RowVector3d center = points.colwise().mean();
    points.rowwise() -= center;
    return points;
  }

  double length_in_plane(const std::vector<VertexHandle>& image) const {
    double length = 0;
    for (const EdgeHandle e : mesh_.edges()) {
      const HalfedgeHandle h = mesh_.halfedge_handle(e, 0);
      const VertexHandle from = mesh_.from_vertex_handle(h), to = mesh_.to_vertex_handle(h);
      if (image[from.idx()] == from && image[to.idx()] == to) length += edge_length(mesh_, h);
    }
    return length;
  }

  const HalfEdgeMesh& mesh_;
  const Positions3 points_;
  const VerticesInOrder in_order_;
  double tolerance_ = 0;
};

}  // namespace

std::vector<VertexHandle> mirror_image(const Chart& chart, const StopToken& stop) {
  return MirrorSearch(chart).best_image(stop);
}

std::vector<VertexHandle> mirror_image(const Chart& chart, const Eigen::RowVector3d& normal) {
  return MirrorSearch(chart).across(normal);
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

MeshPath mirrored(const Chart& chart, const std::vector<VertexHandle>& image, const MeshPath& path) {
  MeshPath result;
  for (const PathPoint& point : path) {
    if (point.is_vertex()) {
      result.push_back(PathPoint::at_vertex(image[point.vertex.idx()]));
      continue;
    }
    // Mirroring reverses the orientation of faces. So the image of a half-edge starts at the image of its end.
    const HalfedgeHandle h = chart.mesh.find_halfedge(image[chart.mesh.to_vertex_handle(point.half_edge).idx()],
                                                      image[chart.mesh.from_vertex_handle(point.half_edge).idx()]);
    if (!h.is_valid()) return {};
    result.push_back(PathPoint::on_edge(h, 1 - point.t));
  }
  for (std::size_t i = 1; i < result.size(); ++i) {
    if (!have_common_face(faces_at(chart.mesh, result[i - 1]), faces_at(chart.mesh, result[i]))) return {};
  }
  return result;
}

}  // namespace wirewarp
