// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace wirewarp {

/// Returns the rank of each value, from 0 for the lowest. Values at most `same` above the next lower one share its
/// rank, so that rounding does not decide the order. Values must not be NaN.
std::vector<int> ranks_of(const std::vector<double>& values, double same);

}  // namespace wirewarp
