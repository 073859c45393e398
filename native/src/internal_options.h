// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "refine/refine_constants.h"
#include "wirewarp/flatten.h"

namespace wirewarp {

/// Options, and what users do not choose: tests do, to reach with small input what large input meets, and trials that
/// want the shape alone.
struct InternalOptions : Options {
  InternalOptions(const Options& options = {}) : Options(options) {}  // NOLINT(google-explicit-constructor)

  std::size_t large_chart = 8'000;  // faces: from here on a coarse start saves more than it costs
  bool with_proposals = true;       // what would mend a piece that fails is looked for: that takes far longer

  bool mends_folds = true;  // another shape is looked for where one is turned over or covers itself
  Aim aim = Aim::minimum;   // of the refined method
};

/// flatten() with such options; the same ones in all runs with one cache.
FlattenResult flatten_with(const FlattenInput& input, const InternalOptions& options, const Progress& progress = {},
                           Cache* cache = nullptr);

}  // namespace wirewarp
