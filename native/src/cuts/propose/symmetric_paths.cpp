// SPDX-License-Identifier: GPL-3.0-or-later
#include "cuts/propose/symmetric_paths.h"

#include <algorithm>

#include "cuts/parts/part_planes.h"
#include "newton/coarsen/coarse_chart.h"

namespace wirewarp {
namespace {

/// Two points count as one place if their distance is below this share of a typical edge length. It is twice the snap
/// of cut_mesh(), which may merge such points.
constexpr double kSamePoint = 0.1;

}  // namespace

PathMirror::PathMirror(const FlattenInput& input, const Chart& chart, const std::vector<VertexHandle>& image)
    : input_(input) {
  if (image.empty()) return;
  const HalfEdgeMesh& mesh = chart.mesh;
  normal_ = mirror_plane(mesh, image).normal.transpose();
  tolerance_ = kSamePoint * typical_edge_length(mesh);
  faces_.resize(static_cast<std::size_t>(input.faces.rows()));
  const auto corner = [&](int face, VertexHandle v) {
    int k = 0;
    while (input.faces(face, k) != chart.source_vertex[v.idx()]) ++k;
    return k;
  };
  for (const FaceHandle f : mesh.faces()) {
    const HalfedgeHandle h = mesh.halfedge_handle(f);
    const HalfedgeHandle other =
        mesh.find_halfedge(image[mesh.to_vertex_handle(h).idx()], image[mesh.from_vertex_handle(h).idx()]);
    if (!other.is_valid() || mesh.is_boundary(other)) continue;
    const VertexHandle apex = mesh.to_vertex_handle(mesh.next_halfedge_handle(h));
    const VertexHandle other_apex = mesh.to_vertex_handle(mesh.next_halfedge_handle(other));
    if (image[apex.idx()] != other_apex) continue;
    const int face = chart.source_face[f.idx()];
    FaceImage& own = faces_[static_cast<std::size_t>(face)];
    own.face = chart.source_face[mesh.face_handle(other).idx()];
    for (const VertexHandle v : mesh.fv_range(f)) own.corners[corner(face, v)] = corner(own.face, image[v.idx()]);
  }
}

PathMirror::Point PathMirror::point_of(const SurfacePath& path, std::size_t i) {
  return {path.faces[i], path.coordinates.row(static_cast<Eigen::Index>(i))};
}

void PathMirror::set_point(SurfacePath& path, std::size_t i, const Point& point) {
  path.faces[i] = point.face;
  path.coordinates.row(static_cast<Eigen::Index>(i)) = point.weights;
}

Eigen::RowVector3d PathMirror::position(const Point& point) const {
  Eigen::RowVector3d place(0, 0, 0);
  for (int k = 0; k < 3; ++k) place += point.weights[k] * input_.vertices.row(input_.faces(point.face, k));
  return place;
}

PathMirror::Point PathMirror::mirrored(const Point& point) const {
  const FaceImage& image = faces_[static_cast<std::size_t>(point.face)];
  Point result{image.face, Eigen::RowVector3d::Zero()};
  for (int k = 0; k < 3; ++k) result.weights[image.corners[k]] = point.weights[k];
  return result;
}

bool PathMirror::has_image(const SurfacePath& path) const {
  return std::all_of(path.faces.begin(), path.faces.end(),
                     [&](int face) { return faces_[static_cast<std::size_t>(face)].face >= 0; });
}

SurfacePath PathMirror::mirrored(const SurfacePath& path) const {
  SurfacePath result = path;
  for (std::size_t i = 0; i < path.faces.size(); ++i) set_point(result, i, mirrored(point_of(path, i)));
  return result;
}

/// Returns a point of the mirror plane near the given point.
PathMirror::Point PathMirror::on_plane(const Point& point) const {
  const Point image = mirrored(point);
  Point result{point.face, Eigen::RowVector3d::Zero()};
  for (int k = 0; k < 3; ++k) {  // only corners that belong to both faces get a weight
    for (int j = 0; j < 3; ++j) {
      if (input_.faces(point.face, k) == input_.faces(image.face, j))
        result.weights[k] = (point.weights[k] + image.weights[j]) / 2;
    }
  }
  const double sum = result.weights.sum();
  if (sum <= 0) return point;
  result.weights /= sum;
  return result;
}

void PathMirror::settle_ends(SurfacePath& path) const {
  for (const std::size_t i : {std::size_t{0}, path.faces.size() - 1}) {
    const Point end = point_of(path, i);
    if (is_near(end, mirrored(end))) set_point(path, i, on_plane(end));
  }
}

/// Changes a path that is nearly its own mirror image. If the path is in the plane, moves it exactly onto the plane. If
/// it crosses the plane, makes its halves exact mirror images.
void PathMirror::settle(SurfacePath& path) const {
  const std::size_t count = path.faces.size();
  const SurfacePath image = mirrored(path);
  bool is_on_plane = true, is_across = true;
  for (std::size_t i = 0; i < count; ++i) {
    is_on_plane = is_on_plane && is_near(point_of(path, i), point_of(image, i));
    is_across = is_across && is_near(point_of(path, i), point_of(image, count - 1 - i));
  }
  if (is_on_plane) {
    for (std::size_t i = 0; i < count; ++i) set_point(path, i, on_plane(point_of(path, i)));
  } else if (is_across) {
    for (std::size_t i = 0; i < count / 2; ++i) set_point(path, count - 1 - i, point_of(image, i));
    if (count % 2 == 1) set_point(path, count / 2, on_plane(point_of(path, count / 2)));
  }
}

/// Returns a positive number if most of the path is on the side to which normal_ points. Returns a negative number if
/// most of it is on the other side.
double PathMirror::side(const SurfacePath& path) const {
  double sum = 0;
  for (std::size_t i = 0; i < path.faces.size(); ++i) {
    const Point point = point_of(path, i);
    sum += (position(point) - position(mirrored(point))).dot(normal_);
  }
  return sum;
}

void PathMirror::make_symmetric(const std::vector<std::size_t>& images, std::vector<SurfacePath>& paths) const {
  if (faces_.empty()) return;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const std::size_t other = images[i];
    if (!has_image(paths[i])) continue;
    if (other == i) {
      settle(paths[i]);
    } else if (images[other] == i && i < other && has_image(paths[other])) {
      const bool is_first = side(paths[i]) >= side(paths[other]);
      SurfacePath& kept = paths[is_first ? i : other];
      settle_ends(kept);
      paths[is_first ? other : i] = mirrored(kept);
    }
  }
}

}  // namespace wirewarp
