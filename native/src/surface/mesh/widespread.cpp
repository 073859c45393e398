// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/mesh/widespread.h"

#include <algorithm>
#include <numeric>

namespace wirewarp {

double widespread(const std::vector<double>& areas, const Eigen::VectorXd& of_faces) {
  // The last factor allows for rounding errors in sums of areas. Without it, the choice among equal triangles could
  // depend on their numbering.
  constexpr double kShare = 0.99 * (1 - 1e-9);
  std::vector<int> order(areas.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int f, int g) { return of_faces[f] < of_faces[g]; });
  const double area = std::accumulate(areas.begin(), areas.end(), 0.0);
  double below = 0;
  for (const int f : order) {
    below += areas[f];
    if (below >= kShare * area) return of_faces[f];
  }
  return of_faces[order.back()];
}

}  // namespace wirewarp
