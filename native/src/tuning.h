// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of the methods that users do not choose; tests do, to reach with small input what large input meets.
#pragma once

#include <cstddef>

#include "wirewarp/flatten.h"

namespace wirewarp {

struct Tuning {
  std::size_t large_chart = 20'000;  // faces: from here on a coarse start saves more than it costs
};

/// flatten() with other figures; the same ones in all runs with one cache.
FlattenResult flatten_with(const FlattenInput& input, const Options& options, const Tuning& tuning,
                           const Progress& progress = {}, Cache* cache = nullptr);

}  // namespace wirewarp
