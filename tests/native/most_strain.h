// SPDX-License-Identifier: GPL-3.0-or-later
// The strain by which suggested cuts are compared, computed from the result of a run.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <vector>

#include "surface/mesh/widespread.h"
#include "wirewarp/flatten.h"

namespace wirewarp::test {

/// Returns the strain of the most strained piece: the value of max(sigma_1, 1/sigma_2) - 1 that 99% of its area does
/// not exceed. Every piece must have a shape.
inline double most_strain(const FlattenInput& input, const FlattenResult& result) {
  double most = 0;
  for (const Piece& piece : result.pieces) {
    std::vector<double> areas;
    for (const int f : piece.source_face) {
      const Eigen::Vector3d a = input.vertices.row(input.faces(f, 0)), b = input.vertices.row(input.faces(f, 1)),
                            c = input.vertices.row(input.faces(f, 2));
      areas.push_back((b - a).cross(c - a).norm() / 2);
    }
    most = std::max(most, widespread(areas, piece.metrics.face_aspect_ratio.array() - 1));
  }
  return most;
}

}  // namespace wirewarp::test
