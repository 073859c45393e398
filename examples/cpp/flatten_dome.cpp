// SPDX-License-Identifier: GPL-3.0-or-later
// Flattens a shallow dome over a square of 1 m. Two lines cross in the middle of the dome: the rigid line must keep its
// length, and the elastic line may change its length by 1%. Prints the lengths of both lines and of the outline, on the
// dome and in the flat piece.
#include <wirewarp/flatten.h>

#include <cmath>
#include <cstdio>

namespace {

constexpr int kCells = 20;  // number of cells along each side

int vertex(int row, int column) { return row * (kCells + 1) + column; }

wirewarp::FlattenInput dome() {
  const double pi = std::acos(-1.0);
  wirewarp::FlattenInput input;
  input.vertices.resize((kCells + 1) * (kCells + 1), 3);
  input.faces.resize(2 * kCells * kCells, 3);
  for (int row = 0; row <= kCells; ++row) {
    for (int column = 0; column <= kCells; ++column) {
      const double x = double(column) / kCells - 0.5;
      const double y = double(row) / kCells - 0.5;
      input.vertices.row(vertex(row, column)) << x, y, 0.1 * std::cos(pi * x) * std::cos(pi * y);
    }
  }
  int face = 0;
  for (int row = 0; row < kCells; ++row) {
    for (int column = 0; column < kCells; ++column) {
      const int a = vertex(row, column);
      const int b = vertex(row, column + 1);
      const int c = vertex(row + 1, column + 1);
      const int d = vertex(row + 1, column);
      input.faces.row(face++) << a, b, c;
      input.faces.row(face++) << a, c, d;
    }
  }
  wirewarp::Wire rigid{{}, 0, "rigid"};
  wirewarp::Wire elastic{{}, 0.01, "elastic"};
  for (int i = 0; i <= kCells; ++i) {
    rigid.vertices.push_back(vertex(kCells / 2, i));
    elastic.vertices.push_back(vertex(i, kCells / 2));
  }
  input.wires = {rigid, elastic};
  return input;
}

}  // namespace

int main() {
  try {
    const wirewarp::FlattenResult result = wirewarp::flatten(dome());
    for (const wirewarp::WireReport& wire : result.wires) {
      std::printf("%s: %.9f m on the dome, %.9f m flat\n", wire.name.c_str(), wire.length_3d, wire.length_2d);
    }
    const wirewarp::Piece& piece = result.pieces.front();
    for (const wirewarp::BoundaryReport& side : piece.boundaries) {
      std::printf("outline: %.9f m on the dome, %.9f m flat\n", side.length_3d, side.length_2d);
    }
    if (piece.error) throw *piece.error;
  } catch (const wirewarp::FlattenError& error) {
    std::fprintf(stderr, "%s: %s\n", wirewarp::describe(error.code).name, error.what());
    return 1;
  }
}
