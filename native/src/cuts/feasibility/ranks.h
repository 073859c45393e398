// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace wirewarp {

/// Returns the rank of each value, from 0 for the lowest. If a value exceeds the next lower value by at most `same`, it
/// has the rank of this lower value. Values must not be NaN.
std::vector<int> ranks_of(const std::vector<double>& values, double same);

/// Returns the indices of the values, highest rank first. Values of one rank keep their order.
std::vector<std::size_t> highest_first(const std::vector<double>& values, double same);

}  // namespace wirewarp
