// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a sheet with a seam, and eases for the sides of the seam.
#pragma once

#include <vector>

#include "test_meshes.h"
#include "wirewarp/flatten.h"

namespace wirewarp::test {

inline Ease ease_along(const std::vector<int>& chain, double ratio) {
  Ease ease{VertexPairs(chain.size() - 1, 2), ratio};
  for (Eigen::Index i = 0; i < ease.half_edges.rows(); ++i) ease.half_edges.row(i) << chain[i], chain[i + 1];
  return ease;
}

/// Returns a sheet of 4 by 2. Its left half is flat and its right half is doubly curved, with a seam between them.
inline FlattenInput sheet_and_saddle() {
  const int n = 8;
  FlattenInput input = make_grid(2 * n, n, [](double s, double t) {
    const double x = 4 * s - 2, y = 2 * t - 1;
    return Eigen::Vector3d(x, y, x > 0 ? 0.2 * x * x * y * y : 0);
  });
  add_seam(input, grid_column(2 * n, n, n));
  return input;
}

inline std::vector<int> seam_of_sheets() { return grid_column(16, 8, 8); }

}  // namespace wirewarp::test
