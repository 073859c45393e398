// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <limits>

namespace wirewarp {

/// b(x) = −(1 − x)² ln x for x < 1 and 0 for x >= 1, with two continuous derivatives; infinite for x <= 0. It is the
/// barrier of incremental potential contact (M. Li et al., ACM Transactions on Graphics 39 (2020), article 49).
struct LogBarrier {
  explicit LogBarrier(double x) {
    if (x >= 1) return;
    if (!(x > 0)) {
      value = std::numeric_limits<double>::infinity();
      return;
    }
    const double rest = 1 - x, log = std::log(x), share = rest / x;
    value = -rest * rest * log;
    slope = 2 * rest * log - rest * share;
    curvature = -2 * log + 4 * share + share * share;
  }
  double value = 0, slope = 0, curvature = 0;  // b, b′, b″
};

}  // namespace wirewarp
