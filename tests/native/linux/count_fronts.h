// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace wirewarp {

/// Number of fronts that all threads of the test program have visited so far in the Cholesky kernels, with up to four
/// right-hand sides at a visit. One machine gives the same numbers in every run. On another one, rounding may end an
/// iteration a step earlier or later.
struct FrontCounts {
  long factored;
  long substituted_forward;
  long substituted_back;
};

FrontCounts count_fronts();

}  // namespace wirewarp
