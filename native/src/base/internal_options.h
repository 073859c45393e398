// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "wirewarp/options.h"

namespace wirewarp {

/// How far the refined method refines a shape.
enum class Target {
  minimum,      // until another step gains nothing worthwhile
  rough,        // until another step gains little: others start from it, and take its direction
  newton_step,  // until a Newton step goes down: others start from it. Farther takes a sixth more factorizations in all
};

/// Options, and what users do not choose. Tests choose it, to reach with small input what large input meets, and trials
/// that need the shape alone.
struct InternalOptions : Options {
  InternalOptions(const Options& options = {}) : Options(options) {}  // NOLINT(google-explicit-constructor)

  std::size_t large_chart = 8'000;  // faces: from here on a coarse start saves more than it costs
  bool with_proposals = true;       // looks for what would fix a piece that fails, which takes far longer

  bool mends_folds = true;  // looks for another shape if one is flipped or overlaps itself
  Target target = Target::minimum;
};

}  // namespace wirewarp
