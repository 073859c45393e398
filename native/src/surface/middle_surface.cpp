// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/middle_surface.h"

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "base/sentence.h"

namespace wirewarp {
namespace {

/// Returns the signed distance from the input to the middle surface, along the normals.
double offset_of(const Options& options) {
  switch (options.surface) {
    case Surface::inside:
      return options.thickness / 2;
    case Surface::middle:
      return 0;
    case Surface::outside:
      return -options.thickness / 2;
  }
  return 0;
}

/// Returns the vector from a corner of a face to the next corner.
Eigen::Vector3d side(const Positions3& vertices, const Triangles& faces, Eigen::Index face, int corner) {
  return vertices.row(faces(face, (corner + 1) % 3)) - vertices.row(faces(face, corner));
}

/// Returns the normal of a face. Its length is twice the area of the face.
Eigen::Vector3d normal_of(const Positions3& vertices, const Triangles& faces, Eigen::Index face) {
  return side(vertices, faces, face, 0).cross(-side(vertices, faces, face, 2));
}

/// Normals count as canceled out if the length of their weighted sum, divided by the sum of the angles around the
/// vertex, is smaller than this. Smaller sums are rounding errors.
constexpr double kCancels = 1e-6;

/// Returns one unit normal per vertex, weighted by angles; zero if the normals around the vertex cancel out (Thürmer,
/// Wüthrich, Computing vertex normals from polygonal facets, 1998).
Positions3 vertex_normals(const FlattenInput& input) {
  Positions3 normals = Positions3::Zero(input.vertices.rows(), 3);
  Eigen::VectorXd angles = Eigen::VectorXd::Zero(input.vertices.rows());
  for (Eigen::Index f = 0; f < input.faces.rows(); ++f) {
    const Eigen::Vector3d normal = normal_of(input.vertices, input.faces, f);
    if (normal.isZero(0)) continue;
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d ahead = side(input.vertices, input.faces, f, k);
      const Eigen::Vector3d back = -side(input.vertices, input.faces, f, (k + 2) % 3);
      const double angle = std::atan2(ahead.cross(back).norm(), ahead.dot(back));
      normals.row(input.faces(f, k)) += angle * normal.normalized().transpose();
      angles[input.faces(f, k)] += angle;
    }
  }
  for (Eigen::Index v = 0; v < normals.rows(); ++v) {
    const double length = normals.row(v).norm();
    normals.row(v) *= length > kCancels * angles[v] ? 1 / length : 0;
  }
  return normals;
}

}  // namespace

FlattenInput move_to_middle(const FlattenInput& input, const Options& options) {
  FlattenInput middle = input;
  middle.vertices += offset_of(options) * vertex_normals(input);
  std::vector<int> turned;
  for (Eigen::Index f = 0; f < input.faces.rows(); ++f) {
    const Eigen::Vector3d before = normal_of(input.vertices, input.faces, f);
    if (!before.isZero(0) && !(before.dot(normal_of(middle.vertices, middle.faces, f)) > 0)) {
      turned.push_back(static_cast<int>(f));
    }
  }
  if (turned.empty()) return middle;
  throw FlattenError(
      ErrorCode::invalid_option,
      ErrorArguments{{"name", "thickness"},
                     {"value", shortest(options.thickness)},
                     {"allowed", "be less, or the surface must be smoother, at " + name_elements("face", turned) +
                                     ", where the surface curves too tightly"}},
      {{}, {}, turned});
}

}  // namespace wirewarp
