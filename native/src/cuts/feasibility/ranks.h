// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace wirewarp {

/// The rank of each value, from 0 for the lowest. Values no more than `same` above the next lower one share its rank,
/// so that rounding decides no order. None of them may be NaN.
std::vector<int> ranks_of(const std::vector<double>& values, double same);

}  // namespace wirewarp
