// SPDX-License-Identifier: GPL-3.0-or-later
// The surface that the benchmarks flatten, at any size. bench/surfaces.py makes the same surface.
#pragma once

#include <cmath>

#include "wirewarp/flatten.h"

namespace wirewarp {

/// Returns a smoothly bent sheet over the square [-1, 1]² with about `triangles` triangles, two in each square of a
/// regular grid. All straight wires have the same tolerance. `wires` must be even: half of the wires run in each
/// direction.
inline FlattenInput bumpy_sheet(int triangles, int wires, double tolerance, double height = 0.3) {
  const int n = static_cast<int>(std::lround(std::sqrt(triangles / 2.0)));
  const auto at = [n](int i, int j) { return j * (n + 1) + i; };
  FlattenInput input;
  input.vertices.resize((n + 1) * (n + 1), 3);
  input.faces.resize(2 * n * n, 3);
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      const double x = 2.0 * i / n - 1, y = 2.0 * j / n - 1;
      input.vertices.row(at(i, j)) << x, y, height * std::sin(3.1 * x + 0.4) * std::cos(2.7 * y - 0.3);
    }
  }
  for (int j = 0, f = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      input.faces.row(f++) << at(i, j), at(i + 1, j), at(i + 1, j + 1);
      input.faces.row(f++) << at(i, j), at(i + 1, j + 1), at(i, j + 1);
    }
  }
  for (int k = 1; k <= wires / 2; ++k) {
    const int line = k * n / (wires / 2 + 1);
    Wire along, across;
    along.tolerance = across.tolerance = tolerance;
    for (int i = 0; i <= n; ++i) {
      along.vertices.push_back(at(i, line));
      across.vertices.push_back(at(line, i));
    }
    input.wires.push_back(along);
    input.wires.push_back(across);
  }
  return input;
}

}  // namespace wirewarp
