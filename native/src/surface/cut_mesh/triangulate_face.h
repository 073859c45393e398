// SPDX-License-Identifier: GPL-3.0-or-later
// Divides one triangle so that given lines between points in it become edges.
#pragma once

#include <array>
#include <set>
#include <vector>

#include "base/planar.h"
#include "wirewarp/types.h"

namespace wirewarp {

/// A point in the plane of a triangle, in coordinates in which the triangle is (0, 0), (1, 0), (0, 1).
using FacePoint = Eigen::Vector2d;

/// Returns twice the area of a triangle, positive if it is counter-clockwise.
inline double doubled_area(const FacePoint& a, const FacePoint& b, const FacePoint& c) { return cross(b - a, c - a); }

/// Three points count as collinear if |doubled_area()| is below this. Points are at least 0.0001 apart in a face with
/// the doubled area 1. So if three points are not collinear, their doubled area is at least 1e-8.
inline constexpr double kInLine = 1e-12;

/// Returns whether two segments cross at an inner point of both. Returns false if an end of one segment is on the line
/// of the other segment.
bool do_cross(const FacePoint& a, const FacePoint& b, const FacePoint& c, const FacePoint& d);

struct FaceToDivide {
  std::vector<FacePoint> points;          // points on the border, counter-clockwise, then points inside
  Positions3 places;                      // positions of the points in space, to prefer short edges
  std::vector<std::array<int, 2>> sides;  // per border point: its two sides if it is a corner, otherwise its side twice
  std::set<std::array<int, 2>> lines;     // edges that must exist, the smaller index first; they do not cross
};

/// Returns triangles with all points, counter-clockwise. Throws std::logic_error if lines cross or pass through points.
std::vector<std::array<int, 3>> triangulate(const FaceToDivide& face);

}  // namespace wirewarp
