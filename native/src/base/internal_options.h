// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "wirewarp/options.h"

namespace wirewarp {

/// When the refined method ends.
enum class Target {
  minimum,  // when another step would not gain anything worthwhile
  rough,    // when another step would gain little; the result is a start for others and gives their direction
  /// After the first descending Newton step; the result is a start for others. Going on takes a sixth more
  /// factorizations.
  newton_step,
};

/// Options that users do not have. Tests use them to reach with small input what otherwise only large input reaches,
/// and the search for cuts uses them to compute shapes only.
struct InternalOptions : Options {
  InternalOptions(const Options& options = {}) : Options(options) {}  // NOLINT(google-explicit-constructor)

  std::size_t large_chart = 8'000;  // number of faces from which a coarse start saves more time than it costs
  bool with_proposals = true;       // searches for fixes of a piece that fails, which takes far longer than the run

  bool mends_folds = true;  // searches for another shape if one is flipped or overlaps itself
  Target target = Target::minimum;
};

}  // namespace wirewarp
