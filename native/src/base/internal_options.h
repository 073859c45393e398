// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "wirewarp/options.h"

namespace wirewarp {

/// The point at which the refined method ends.
enum class Target {
  minimum,  // when no further step is worthwhile
  rough,    // when another step would gain little; enough for starts, directions of fabric and coarse evaluations
  /// The method ends after the first Newton step that decreases f, and the shape is a start for other runs. Longer runs
  /// would increase the total number of factorizations by a sixth.
  newton_step,
};

/// Options that users cannot set. Tests use them to run the code for large input on small input. The search for cuts
/// uses them to compute shapes only.
struct InternalOptions : Options {
  InternalOptions(const Options& options = {}) : Options(options) {}  // NOLINT(google-explicit-constructor)

  std::size_t large_chart = 8'000;  // least number of faces for which a coarse start saves time
  bool with_proposals = true;  // whether to search for fixes of a failed piece, which takes far longer than flattening

  bool makes_injective = true;  // whether to search for an injective shape if faces are flipped or overlap
  Target target = Target::minimum;
};

}  // namespace wirewarp
