// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cuts/propose/surface_lines.h"
#include "surface/charts/chart.h"
#include "wirewarp/surface_path.h"

namespace wirewarp {

/// Makes mirrored lines exact mirror images. Without this step, they differ, because relaxing lines increases rounding
/// errors near vertices.
class PathMirror {
 public:
  /// image: mirror image of each vertex, or empty. The input must outlive the object.
  PathMirror(const FlattenInput& input, const Chart& chart, const std::vector<VertexHandle>& image);

  /// Makes one path of each mirrored pair the image of the other path. Makes paths that are their own image symmetric.
  /// images: index of each path's image; its own index if there is none.
  void make_symmetric(const std::vector<std::size_t>& images, std::vector<SurfacePath>& paths) const;

 private:
  using Point = WeightedPoint;

  struct FaceImage {
    int face = -1;
    int corners[3] = {0, 0, 0};  // per corner of the face: the corner of the image
  };

  static Point point_of(const SurfacePath& path, std::size_t i);
  static void set_point(SurfacePath& path, std::size_t i, const Point& point);
  Eigen::RowVector3d position(const Point& point) const;
  Point mirrored(const Point& point) const;
  bool is_near(const Point& a, const Point& b) const { return (position(a) - position(b)).norm() < tolerance_; }
  bool has_image(const SurfacePath& path) const;
  SurfacePath mirrored(const SurfacePath& path) const;
  Point on_plane(const Point& point) const;
  void settle_ends(SurfacePath& path) const;
  void settle(SurfacePath& path) const;
  double side(const SurfacePath& path) const;

  const FlattenInput& input_;
  std::vector<FaceImage> faces_;  // image of each input face; empty: no mirror plane
  Eigen::RowVector3d normal_;     // of the mirror plane
  double tolerance_ = 0;          // scene units
};

}  // namespace wirewarp
