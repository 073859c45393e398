// SPDX-License-Identifier: GPL-3.0-or-later
#include "small_mesh.h"

#include <algorithm>
#include <cmath>

namespace wirewarp::test {
namespace {

constexpr double kPi = 3.141592653589793;

int any_vertex(RandomStream& random, const FlattenInput& input) {
  return random.below(static_cast<int>(input.vertices.rows()));
}

void add_face(FlattenInput& input, int a, int b, int c) {
  input.faces.conservativeResize(input.faces.rows() + 1, 3);
  input.faces.bottomRows(1) << a, b, c;
}

int add_vertex(FlattenInput& input, const Eigen::RowVector3d& position) {
  input.vertices.conservativeResize(input.vertices.rows() + 1, 3);
  input.vertices.bottomRows(1) = position;
  return static_cast<int>(input.vertices.rows()) - 1;
}

void take_out(FlattenInput& input, int face) {
  input.faces.row(face) = input.faces.row(input.faces.rows() - 1).eval();
  input.faces.conservativeResize(input.faces.rows() - 1, 3);
}

/// Divides a face into three, around a new vertex.
void split(FlattenInput& input, int face) {
  const int a = input.faces(face, 0), b = input.faces(face, 1), c = input.faces(face, 2);
  const int middle = add_vertex(input, (input.vertices.row(a) + input.vertices.row(b) + input.vertices.row(c)) / 3);
  input.faces(face, 2) = middle;
  add_face(input, b, c, middle);
  add_face(input, c, a, middle);
}

void weld(FlattenInput& input, int kept, int replaced) {
  std::replace(input.faces.data(), input.faces.data() + input.faces.size(), replaced, kept);
}

void change_one(RandomStream& random, FlattenInput& input) {
  const int face = random.below(static_cast<int>(input.faces.rows()));
  const int a = any_vertex(random, input), b = any_vertex(random, input);
  switch (random.below(10)) {
    case 0:
      return std::swap(input.faces(face, 0), input.faces(face, 1));
    case 1:
      return weld(input, a, b);
    case 2:
      return add_face(input, a, b, any_vertex(random, input));
    case 3:
      input.faces(face, random.below(3)) = a;
      return;
    case 4:
      input.vertices.row(a) = input.vertices.row(b);
      return;
    case 5:
      input.vertices.row(a) *= random.across_scales(1e-9, 1e9);
      return;
    case 6:
      return split(input, face);
    default:
      return take_out(input, face);
  }
}

}  // namespace

FlattenInput small_mesh(RandomStream& random) {
  const int nx = random.whole(1, 5), ny = random.whole(1, 5);
  const bool wraps_x = nx > 2 && random.chance(0.3), wraps_y = ny > 2 && random.chance(0.3);
  const int columns = wraps_x ? nx : nx + 1, rows = wraps_y ? ny : ny + 1;
  FlattenInput input;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const double x = i + 0.4 * random.between(-1, 1), y = j + 0.4 * random.between(-1, 1);
      const double s = 2 * kPi * x / nx, t = 2 * kPi * y / ny, high = random.between(-1, 1);
      const double radius = wraps_y ? 2 + 0.5 * std::cos(t) : 2;
      add_vertex(input, wraps_x
                            ? Eigen::RowVector3d(radius * std::cos(s), radius * std::sin(s), wraps_y ? std::sin(t) : y)
                        : wraps_y ? Eigen::RowVector3d(x, 2 * std::cos(t), 2 * std::sin(t))
                                  : Eigen::RowVector3d(x, y, high));
    }
  }
  const auto index = [&](int i, int j) { return i % columns + columns * (j % rows); };
  for (int j = 0; j < ny; ++j) {
    for (int i = 0; i < nx; ++i) {
      const int a = index(i, j), b = index(i + 1, j), c = index(i + 1, j + 1), d = index(i, j + 1);
      const bool turned = random.chance(0.5);  // direction of the diagonal
      add_face(input, a, b, turned ? d : c);
      add_face(input, turned ? b : a, c, d);
    }
  }
  return input;
}

void change_faces(RandomStream& random, FlattenInput& input) {
  for (int changes = random.chance(0.5) ? random.whole(1, 8) : 0; changes > 0 && input.faces.rows() > 1; --changes) {
    change_one(random, input);
  }
}

}  // namespace wirewarp::test
