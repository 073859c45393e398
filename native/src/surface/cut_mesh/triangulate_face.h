// SPDX-License-Identifier: GPL-3.0-or-later
// Divides one triangle so that given lines between points in it become edges.
#pragma once

#include <array>
#include <set>
#include <vector>

#include "wirewarp/types.h"

namespace wirewarp {

/// A point of the plane of a triangle, in coordinates in which the triangle is (0, 0), (1, 0), (0, 1).
using FacePoint = std::array<double, 2>;

/// Twice the area of a triangle: positive if counter-clockwise.
inline double doubled_area(const FacePoint& a, const FacePoint& b, const FacePoint& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Three points with less doubled area are in line. The triangle has 1, and points that are 0.0001 apart, the least
/// that callers allow, span 1e-8 or are in line but for rounding.
inline constexpr double kInLine = 1e-12;

/// Returns whether two segments cross in their insides; false if an end of one is in line with the other.
bool do_cross(const FacePoint& a, const FacePoint& b, const FacePoint& c, const FacePoint& d);

struct FaceToDivide {
  std::vector<FacePoint> points;          // the rim counter-clockwise, then those inside
  Positions3 places;                      // of the points in space: short edges are preferred
  std::vector<std::array<int, 2>> sides;  // per point of the rim: the sides that have it; twice the same but at corners
  std::set<std::array<int, 2>> lines;     // points that an edge must join, the smaller index first; they do not cross
};

/// Triangles of all points, counter-clockwise. Throws std::logic_error if lines cross or pass through points.
std::vector<std::array<int, 3>> triangulate(const FaceToDivide& face);

}  // namespace wirewarp
