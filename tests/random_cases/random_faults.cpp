// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <set>

#include "random_input.h"

namespace wirewarp::test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Appends a ring of eight quads without one triangle, so that only a vertex connects the ends of the ring.
void append_ring_that_touches_itself(FlattenInput& input, const Eigen::RowVector3d& at, double size) {
  constexpr int kAround = 8;
  const int first = static_cast<int>(input.vertices.rows());
  for (int i = 0; i < kAround; ++i) {
    const double angle = 2 * 3.141592653589793 * i / kAround;
    for (const double radius : {1.0, 2.0}) {
      add_vertex(input, at + size * radius * Eigen::RowVector3d(std::cos(angle), std::sin(angle), 0));
    }
  }
  for (int i = 0; i < kAround; ++i) {
    const int inner = first + 2 * i, next = first + 2 * ((i + 1) % kAround);
    add_face(input, inner, inner + 1, next + 1);
    if (i + 1 < kAround) add_face(input, inner, next + 1, next);
  }
}

/// Removes all seams and wires. A seam would make a third face at an edge legal, and would separate a flipped face from
/// its neighbors.
void clear_marks(FlattenInput& input) {
  input.seams.resize(0, 2);
  input.wires.clear();
}

/// Returns a face that has a common edge with a face of the same orientation, or -1 if there is none.
int face_with_neighbor(RandomStream& random, const FlattenInput& input) {
  std::set<VertexPair> directed;
  for (int f = 0; f < input.faces.rows(); ++f) {
    for (int k = 0; k < 3; ++k) directed.insert({input.faces(f, k), input.faces(f, (k + 1) % 3)});
  }
  std::vector<int> found;
  for (int f = 0; f < input.faces.rows(); ++f) {
    bool has_neighbor = false;
    for (int k = 0; k < 3; ++k) {
      has_neighbor = has_neighbor || directed.count({input.faces(f, (k + 1) % 3), input.faces(f, k)}) > 0;
    }
    if (has_neighbor) found.push_back(f);
  }
  return found.empty() ? -1 : random.pick(found);
}

}  // namespace

ErrorCode add_random_fault(RandomStream& random, FlattenInput& input, Options& options) {
  const int f = random.below(static_cast<int>(input.faces.rows()));
  const int a = input.faces(f, 0), b = input.faces(f, 1), c = input.faces(f, 2);
  const int num_vertices = static_cast<int>(input.vertices.rows());
  options.grain = -1;  // some faults remove wires, and the grain wire must exist
  switch (random.below(18)) {
    case 0:
      input.faces.resize(0, 3);
      return ErrorCode::empty_mesh;
    case 1:
      input.faces(f, random.below(3)) =
          random.chance(0.5) ? -1 - random.below(1000) : num_vertices + random.below(1000);
      return ErrorCode::vertex_out_of_range;
    case 2:
      input.vertices(a, random.below(3)) =
          random.pick(std::vector<double>{kNan, std::numeric_limits<double>::infinity(), -1e300});
      return ErrorCode::non_finite_coordinates;
    case 3:
      input.seams.resize(1, 2);
      input.seams << a, a;
      return ErrorCode::seam_not_an_edge;
    case 4:
      input.wires.push_back({{a, add_vertex(input, {0, 0, 0})}, 0, "loose"});
      return ErrorCode::wire_not_an_edge;
    case 5:
      input.wires.push_back({random.chance(0.5) ? std::vector<int>{} : std::vector<int>{a}, 0, "short"});
      return ErrorCode::wire_too_short;
    case 6:
      input.wires = {{{a, b, c}, 0, "first"}, {{c, b}, 0.1, "second"}};
      return ErrorCode::edge_in_two_wires;
    case 7:
      input.wires = {{{a, b}, random.pick(std::vector<double>{-1e-300, -1, kNan}), "bad"}};
      return ErrorCode::invalid_tolerance;
    case 8:
      clear_marks(input);
      add_face(input, a, b, a);
      return ErrorCode::repeated_vertex_in_face;
    case 9:
      clear_marks(input);
      add_face(input, b, c, a);
      return ErrorCode::repeated_face;
    case 10:
      clear_marks(input);
      add_face(input, a, b, add_vertex(input, input.vertices.row(a)));
      return ErrorCode::zero_area_face;
    case 11: {
      clear_marks(input);
      const Eigen::RowVector3d side = input.vertices.row(b) - input.vertices.row(a);
      const Eigen::RowVector3d other = input.vertices.row(c) - input.vertices.row(a);
      const Eigen::RowVector3d up = input.vertices.row(a) + side.cross(other).normalized() * side.norm();
      add_face(input, b, a, add_vertex(input, up));
      add_face(input, b, a, add_vertex(input, up + 0.3 * side));  // at least three faces at a-b
      return ErrorCode::non_manifold_edge;
    }
    case 12:
      clear_marks(input);
      append_ring_that_touches_itself(input, input.vertices.row(a),
                                      (input.vertices.row(b) - input.vertices.row(a)).norm());
      return ErrorCode::non_manifold_vertex;
    case 13: {
      clear_marks(input);
      const int turned = face_with_neighbor(random, input);
      if (turned < 0) {  // no face has a neighbor, as in a mesh of one triangle
        options.gap = -1;
        return ErrorCode::invalid_option;
      }
      std::swap(input.faces(turned, 0), input.faces(turned, 1));
      return ErrorCode::inconsistent_orientation;
    }
    case 14:
      options.fairness = random.pick(std::vector<double>{0, -1, 1e9, kNan});
      return ErrorCode::invalid_option;
    case 15:
      options.grain = random.chance(0.5) ? static_cast<int>(input.wires.size()) + random.below(3) : -2;
      return ErrorCode::invalid_option;
    case 16:
      options.up = random.chance(0.5) ? std::array<double, 3>{0, 0, 0} : std::array<double, 3>{0, kNan, 1};
      return ErrorCode::invalid_option;
    default:
      options.max_factorizations = -random.below(3);
      return ErrorCode::invalid_option;
  }
}

}  // namespace wirewarp::test
