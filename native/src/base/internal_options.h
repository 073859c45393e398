// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "wirewarp/options.h"

namespace wirewarp {

/// The point at which the refined method ends.
enum class Target {
  minimum,  // when another step would gain nothing worthwhile
  rough,    // when another step would gain little; the result is a start for others, and determines the direction
  /// After the first Newton step that decreases f; the result is a start for others. Continuing would increase the
  /// total number of factorizations by a sixth.
  newton_step,
};

/// Options that users do not have. With them, tests with small input run code that otherwise only large input runs, and
/// the search for cuts computes shapes only.
struct InternalOptions : Options {
  InternalOptions(const Options& options = {}) : Options(options) {}  // NOLINT(google-explicit-constructor)

  std::size_t large_chart = 8'000;  // least number of faces for which a coarse start saves time
  bool with_proposals = true;  // whether to search for fixes of a failed piece, which takes far longer than the run

  bool makes_injective = true;  // whether to search for an injective shape if faces are flipped or overlap
  Target target = Target::minimum;
};

}  // namespace wirewarp
