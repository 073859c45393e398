// SPDX-License-Identifier: GPL-3.0-or-later
#include "cuts/propose/flat_width.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "base/disjoint_sets.h"
#include "base/planar.h"
#include "surface/charts/enclosed_area.h"
#include "surface/orientation/convex_hull.h"

namespace wirewarp {
namespace {

/// Number of grid points along the largest requested radius. The error of a radius is at most 0.7 grid steps, which is
/// 7% of the largest radius: see kWidthError.
constexpr double kPointsPerRadius = 10;

/// A shape that is more than this many grid points long gets a coarser grid, so that huge shapes do not fill the
/// memory. The distances of 1500² points need 18 MB.
constexpr double kMostPoints = 1500;

/// Shares of the shape's area, as in wirewarp.pattern. Of the parts that disks cover, parts below kScrap are ignored.
/// One part of at least kMostArea must remain.
constexpr double kScrap = 0.1, kMostArea = 0.5;

/// kSteps: number of radii that are tried, up to the largest radius. kHalvings: number of bisections between two radii.
/// The result has an error of 1/128 of the largest radius, far below the error of the grid.
constexpr int kSteps = 8, kHalvings = 4;

/// Share of a grid step or radius, far above rounding errors, so that grid points on a border count as inside.
constexpr double kRounding = 1e-9;

/// Points of a flat shape on a regular grid, with the distance of each point to the outline.
class DistanceGrid {
 public:
  /// reach: largest distance in the grid, in scene units. It replaces larger distances.
  DistanceGrid(const HalfEdgeMesh& mesh, const Positions2& uv, double reach) : reach_(reach) {
    const Eigen::Matrix<double, Eigen::Dynamic, 2> points = in_own_frame(mesh, uv);
    const Eigen::Array2d low = points.colwise().minCoeff(), high = points.colwise().maxCoeff();
    step_ = std::max(reach / kPointsPerRadius, (high - low).maxCoeff() / kMostPoints);
    low_ = (low / step_).floor().cast<int>();
    size_ = (high / step_).ceil().cast<int>() - low_ + 1;
    distances_.assign(static_cast<std::size_t>(size_.x()) * static_cast<std::size_t>(size_.y()), 0);
    for (const FaceHandle f : mesh.faces()) fill(mesh, points, f);
    for (const HalfedgeHandle h : mesh.halfedges()) {
      if (!mesh.is_boundary(h)) continue;
      approach(points.row(mesh.from_vertex_handle(h).idx()), points.row(mesh.to_vertex_handle(h).idx()));
    }
  }

  /// Returns whether disks of this radius cover one large part of the shape, and otherwise only scraps: see kScrap.
  bool is_whole(double radius) const {
    const std::vector<Run> runs = runs_inside(radius);
    int num_parts = 0, num_kept = 0;
    double kept = 0;
    const std::vector<int> part = parts_of(runs, num_parts);
    for (int p = 0; p < num_parts; ++p) {
      std::vector<Run> own;
      for (std::size_t i = 0; i < runs.size(); ++i) {
        if (part[i] == p) own.push_back(runs[i]);
      }
      double covered = area_of(own);
      if (covered < kMostArea * area_) covered += area_around(own, radius);
      if (covered < kScrap * area_) continue;
      ++num_kept;
      kept = covered;
    }
    return num_kept == 1 && kept >= kMostArea * area_;
  }

 private:
  using Cell = Eigen::Array2i;
  using Point = Eigen::Vector2d;

  /// Consecutive points of a row, from `begin` to before `end`.
  struct Run {
    int y, begin, end;
  };

  /// Sets area_, and returns the points relative to the centroid, with the first axis towards the farthest vertex. So
  /// the grid turns with the shape.
  Eigen::Matrix<double, Eigen::Dynamic, 2> in_own_frame(const HalfEdgeMesh& mesh, const Positions2& uv) {
    Point center = Point::Zero();
    for (const FaceHandle f : mesh.faces()) {
      const std::array<Point, 3> corners = corners_of(mesh, uv, f);
      const double area = std::abs(cross(corners[1] - corners[0], corners[2] - corners[0])) / 2;
      center += area / 3 * (corners[0] + corners[1] + corners[2]);
      area_ += area;
    }
    center /= area_;
    const Eigen::Matrix<double, Eigen::Dynamic, 2> from_center = uv.rowwise() - center.transpose();
    Eigen::Index farthest = 0;
    from_center.rowwise().squaredNorm().maxCoeff(&farthest);
    const Point along = from_center.row(farthest).normalized();
    Eigen::Matrix2d turn;
    turn << along.x(), -along.y(), along.y(), along.x();
    return from_center * turn;
  }

  template <class Points>
  static std::array<Point, 3> corners_of(const HalfEdgeMesh& mesh, const Points& points, FaceHandle f) {
    std::array<Point, 3> corners;
    std::size_t i = 0;
    for (const VertexHandle v : mesh.fv_range(f)) corners[i++] = points.row(v.idx());
    return corners;
  }

  std::size_t index_of(const Cell& cell) const {
    return static_cast<std::size_t>(cell.y()) * static_cast<std::size_t>(size_.x()) +
           static_cast<std::size_t>(cell.x());
  }

  Point point_of(const Cell& cell) const { return (cell + low_).cast<double>() * step_; }

  /// Calls visit for each grid point in a box. low, high: corners of the box, in scene units.
  template <class Visit>
  void for_each_cell(const Eigen::Array2d& low, const Eigen::Array2d& high, const Visit& visit) const {
    const Cell first = ((low / step_).ceil().cast<int>() - low_).max(0);
    const Cell last = ((high / step_).floor().cast<int>() - low_).min(size_ - 1);
    for (int y = first.y(); y <= last.y(); ++y) {
      for (int x = first.x(); x <= last.x(); ++x) visit(Cell(x, y));
    }
  }

  /// Marks the points inside a face.
  void fill(const HalfEdgeMesh& mesh, const Eigen::Matrix<double, Eigen::Dynamic, 2>& points, FaceHandle f) {
    const std::array<Point, 3> corners = corners_of(mesh, points, f);
    const Eigen::Array2d low = corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]);
    const Eigen::Array2d high = corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]);
    const double rounding = kRounding * step_ * step_;  // points on the edge between two faces must be inside
    for_each_cell(low - kRounding * step_, high + kRounding * step_, [&](const Cell& cell) {
      const Point p = point_of(cell);
      int num_left = 0, num_right = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        const double side = cross(corners[(i + 1) % 3] - corners[i], p - corners[i]);
        num_left += side >= -rounding;
        num_right += side <= rounding;
      }
      if (num_left == 3 || num_right == 3) distances_[index_of(cell)] = reach_;
    });
  }

  /// Lowers the distances of points near an edge of the outline. from, to: ends of the edge.
  void approach(const Point& from, const Point& to) {
    const Point along = to - from;
    const double length2 = along.squaredNorm();
    const Eigen::Array2d low = from.cwiseMin(to).array() - reach_, high = from.cwiseMax(to).array() + reach_;
    for_each_cell(low, high, [&](const Cell& cell) {
      const Point p = point_of(cell) - from;
      const double share = length2 > 0 ? std::clamp(p.dot(along) / length2, 0.0, 1.0) : 0;
      double& distance = distances_[index_of(cell)];
      distance = std::min(distance, (p - share * along).norm());
    });
  }

  /// Returns the runs of points at least `radius` away from the outline, row by row.
  std::vector<Run> runs_inside(double radius) const {
    std::vector<Run> runs;
    for (int y = 0; y < size_.y(); ++y) {
      const double* row = distances_.data() + index_of({0, y});
      for (int x = 0; x < size_.x(); ++x) {
        if (row[x] < (1 - kRounding) * radius) continue;
        const int first = x;
        while (x < size_.x() && row[x] >= (1 - kRounding) * radius) ++x;
        runs.push_back({y, first, x});
      }
    }
    return runs;
  }

  /// Returns the index of the part that contains each run. Runs are connected if some of their points are neighbors,
  /// even diagonally.
  static std::vector<int> parts_of(const std::vector<Run>& runs, int& num_parts) {
    DisjointSets parts(runs.size());
    for (std::size_t i = 0, below = 0; i < runs.size(); ++i) {
      while (runs[below].y + 1 < runs[i].y || (runs[below].y + 1 == runs[i].y && runs[below].end < runs[i].begin))
        ++below;
      for (std::size_t j = below; runs[j].y + 1 == runs[i].y && runs[j].begin <= runs[i].end; ++j)
        parts.unite(static_cast<int>(i), static_cast<int>(j));
    }
    return parts.number(num_parts);
  }

  double area_of(const std::vector<Run>& runs) const {
    int count = 0;
    for (const Run& run : runs) count += run.end - run.begin;
    return count * step_ * step_;
  }

  /// Disks around the points of a part also cover area outside of the part. Returns this area. runs: the part.
  double area_around(const std::vector<Run>& runs, double radius) const {
    std::vector<char> is_covered(distances_.size(), 0);
    for (const Run& run : runs)
      std::fill_n(is_covered.begin() + static_cast<std::ptrdiff_t>(index_of({run.begin, run.y})), run.end - run.begin,
                  char{1});
    int count = 0;
    for (const Run& run : runs) {
      for (int x = run.begin; x < run.end; ++x) {
        if (is_surrounded({x, run.y}, radius)) continue;
        const Point center = point_of({x, run.y});
        for_each_cell(center.array() - radius, center.array() + radius, [&](const Cell& cell) {
          char& is_known = is_covered[index_of(cell)];
          if (is_known != 0 || (point_of(cell) - center).squaredNorm() > radius * radius) return;
          is_known = 1;
          ++count;
        });
      }
    }
    return count * step_ * step_;
  }

  bool is_surrounded(const Cell& cell, double radius) const {
    const std::array<Cell, 4> around{Cell(cell.x() - 1, cell.y()), Cell(cell.x() + 1, cell.y()),
                                     Cell(cell.x(), cell.y() - 1), Cell(cell.x(), cell.y() + 1)};
    return std::all_of(around.begin(), around.end(), [&](const Cell& next) {
      return (next >= 0).all() && (next < size_).all() && distances_[index_of(next)] >= (1 - kRounding) * radius;
    });
  }

  const double reach_;
  double step_ = 0;
  double area_ = 0;
  Cell low_, size_;
  std::vector<double> distances_;  // row by row; 0 outside
};

}  // namespace

double flat_width(const HalfEdgeMesh& mesh, const Positions2& uv, double most) {
  const DistanceGrid grid(mesh, uv, most / 2);
  double whole = 0, broken = most / 2;
  for (int i = 1; i <= kSteps; ++i) {
    const double radius = most / 2 * i / kSteps;
    if (!grid.is_whole(radius)) {
      broken = radius;
      break;
    }
    whole = radius;
  }
  if (whole == broken) return most;
  for (int i = 0; i < kHalvings; ++i) {
    const double radius = (whole + broken) / 2;
    (grid.is_whole(radius) ? whole : broken) = radius;
  }
  return 2 * whole;
}

bool is_narrow(const FlatPiece& piece, double narrowest) {
  return narrowest > 0 && !piece.error && flat_width(piece.chart.mesh, piece.uv, narrowest) < narrowest;
}

int count_narrow(const FlatPieces& pieces, double narrowest) {
  return static_cast<int>(
      std::count_if(pieces.begin(), pieces.end(), [&](const auto& piece) { return is_narrow(*piece, narrowest); }));
}

double solidity(const FlatPiece& piece) {
  std::vector<Eigen::Vector2d> points;
  for (const auto& point : piece.uv.rowwise()) points.emplace_back(point);
  double twice_hull = 0;
  const std::vector<Eigen::Vector2d> hull = convex_hull(points);
  for (std::size_t i = 0; i < hull.size(); ++i) twice_hull += cross(hull[i], hull[(i + 1) % hull.size()]);
  return 2 * enclosed_area(piece.chart, piece.uv) / twice_hull;
}

}  // namespace wirewarp
