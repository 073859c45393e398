// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/orientation/upright_direction.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/planar.h"
#include "surface/mesh/geometry.h"
#include "surface/orientation/convex_hull.h"
#include "surface/orientation/rising_direction.h"
#include "surface/orientation/straightest_outline.h"

namespace wirewarp {
namespace {

// Relative difference up to which sizes and heights count as equal, so that rounding errors and numbering do not choose
// between the sides of a symmetric piece.
constexpr double kSameSize = 1e-6;

// A chord below this fraction of its chain's length does not define the chain's direction. For
// example, a circle with a gap of 33 degrees has no direction.
constexpr double kShortChord = 0.1;

/// Returns the long side of the smallest rectangle around the points. One side of the rectangle is on a side of the
/// convex hull, and rotating calipers (Toussaint, 1983) find the others.
Eigen::Vector2d long_side_of_smallest_box(const std::vector<Eigen::Vector2d>& points) {
  const std::vector<Eigen::Vector2d> hull = convex_hull(points);
  double best_area = std::numeric_limits<double>::infinity();
  Eigen::Vector2d best(0, 0);
  const auto corner = [&](std::size_t i) { return hull[i % hull.size()]; };
  std::size_t right = 0, top = 0, left = 0;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Eigen::Vector2d along = (corner(i + 1) - corner(i)).normalized();
    const Eigen::Vector2d across(-along.y(), along.x());
    const auto farthest = [&](std::size_t from, const Eigen::Vector2d& direction) {
      while (from < i + hull.size() && direction.dot(corner(from + 1) - corner(from)) > 0) ++from;
      return from;
    };
    right = farthest(std::max(right, i), along);
    top = farthest(std::max(top, right), across);
    left = farthest(std::max(left, top), -along);
    const double low = along.dot(corner(left) - corner(i)), high = along.dot(corner(right) - corner(i));
    const double width = across.dot(corner(top) - corner(i));
    const double area = (high - low) * width;
    if (area >= best_area * (1 - kSameSize)) continue;
    best_area = area;
    best = high - low >= width ? along : across;
  }
  return best;
}

std::vector<Eigen::Vector2d> points_along(const Chart& chart, const HalfEdgeChain& chain, const Positions2& uv) {
  std::vector<Eigen::Vector2d> points;
  for (const VertexHandle v : vertices_along(chart.mesh, chain)) points.push_back(uv.row(v.idx()));
  return points;
}

/// Returns whether the chord of a chain is long enough to define its direction.
bool is_open(const std::vector<Eigen::Vector2d>& points) {
  double length = 0;  // length in the plane, because free wires have a different length there
  for (std::size_t i = 1; i < points.size(); ++i) length += (points[i] - points[i - 1]).norm();
  return (points.back() - points.front()).norm() >= kShortChord * length;
}

/// Returns the chord of a chain. If the chain is nearly closed, returns the long side of the smallest box around the
/// chain.
Eigen::Vector2d direction_of(const Chart& chart, const HalfEdgeChain& chain, const Positions2& uv) {
  const std::vector<Eigen::Vector2d> points = points_along(chart, chain, uv);
  const Eigen::Vector2d chord = points.back() - points.front();
  if (is_open(points)) return chord;
  const Eigen::Vector2d side = long_side_of_smallest_box(points);
  Eigen::Vector2d mean(0, 0);
  for (const Eigen::Vector2d& p : points) mean += p / static_cast<double>(points.size());
  return side.dot(points.front() - mean) > 0 ? Eigen::Vector2d(-side) : side;  // the chain starts at the lower end
}

const HalfEdgeChain& longest_boundary_chain(const Chart& chart) {
  const HalfEdgeChain* best = nullptr;
  double best_length = 0;
  for (const BoundaryChain& chain : chart.boundary_chains) {
    const double length = length_of(chart.mesh, chain.half_edges);
    if (best && length <= best_length * (1 + kSameSize)) continue;
    best = &chain.half_edges;
    best_length = length;
  }
  return *best;
}

/// Returns the first part of the grain wire in a chart; nullptr if the wire does not cross the chart.
const HalfEdgeChain* grain_in(const Chart& chart, int grain) {
  const auto part = std::find_if(chart.wire_parts.begin(), chart.wire_parts.end(),
                                 [&](const WirePart& each) { return each.wire_index == grain; });
  return part == chart.wire_parts.end() ? nullptr : &part->half_edges;
}

/// Returns the chain that defines up for Orientation::wire.
const HalfEdgeChain& upright_chain(const Chart& chart, int grain) {
  if (const HalfEdgeChain* chosen = grain_in(chart, grain)) return *chosen;
  return chart.wire_parts.empty() ? longest_boundary_chain(chart) : chart.wire_parts.front().half_edges;
}

/// Returns the orientation that applies to this chart. For Orientation::grain, this is wire or up.
Orientation orientation_of(const Chart& chart, const Options& options) {
  if (options.orientation != Orientation::grain) return options.orientation;
  return grain_in(chart, options.grain) != nullptr ? Orientation::wire : Orientation::up;
}

}  // namespace

Eigen::Vector2d upright_direction(const Chart& chart, const Positions2& uv, const Options& options) {
  const Orientation orientation = orientation_of(chart, options);
  if (orientation == Orientation::boundary) return straightest_outline(chart, uv);
  if (orientation == Orientation::up) {
    const Eigen::Vector2d rising = rising_direction(chart, uv, {options.up[0], options.up[1], options.up[2]});
    if (!rising.isZero(0)) return rising;
  }
  const Eigen::Vector2d along = direction_of(chart, upright_chain(chart, options.grain), uv);
  const double angle = orientation == Orientation::wire ? options.grain_angle : 0;
  return angle == 0 ? along : Eigen::Vector2d(Eigen::Rotation2Dd(-angle) * along);
}

void stand_upright(Positions2& uv, const Eigen::Vector2d& up) {
  Eigen::Matrix2d transposed_rotation = Eigen::Matrix2d::Identity();
  if (up.norm() > 0) {
    const Eigen::Vector2d y = up.normalized();
    transposed_rotation << y.y(), y.x(), -y.x(), y.y();
  }
  const Eigen::RowVector2d center = (uv.colwise().minCoeff() + uv.colwise().maxCoeff()) / 2;
  for (Eigen::Index v = 0; v < uv.rows(); ++v) {
    // The layout is rotated around its center, because small numbers have smaller rounding errors.
    uv.row(v) = ((uv.row(v) - center) * transposed_rotation).eval();
  }
  const Eigen::RowVector2d corner = uv.colwise().minCoeff();
  uv.rowwise() -= corner;
}

VertexPair upright_pair(const Chart& chart, const Positions2& uv, const Options& options) {
  if (orientation_of(chart, options) == Orientation::wire) {
    const HalfEdgeChain& chain = upright_chain(chart, options.grain);
    if (is_open(points_along(chart, chain, uv))) {
      return {chart.mesh.from_vertex_handle(chain.front()).idx(), chart.mesh.to_vertex_handle(chain.back()).idx()};
    }
  }
  std::vector<int> outline;
  for (const HalfedgeHandle h : chart.boundary_loops.front()) outline.push_back(chart.mesh.from_vertex_handle(h).idx());
  const auto is_lower = [&](int v, int w) { return uv(v, 1) < uv(w, 1); };
  const auto [lowest, highest] = std::minmax_element(outline.begin(), outline.end(), is_lower);
  const double same_height = kSameSize * (uv(*highest, 1) - uv(*lowest, 1));
  const auto leftmost_beside = [&](int extreme) {
    int leftmost = extreme;
    for (const int v : outline) {
      const bool is_beside = std::abs(uv(v, 1) - uv(extreme, 1)) <= same_height;
      if (is_beside && uv(v, 0) < uv(leftmost, 0)) leftmost = v;
    }
    return leftmost;
  };
  return {leftmost_beside(*lowest), leftmost_beside(*highest)};
}

}  // namespace wirewarp
