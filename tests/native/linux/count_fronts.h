// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace wirewarp {

/// How many fronts the Cholesky kernels of the test program have visited so far, in all threads, each with up to four
/// right-hand sides. On one machine the same in every run; elsewhere rounding may end an iteration a step apart.
struct FrontCounts {
  long factored;
  long substituted_forward;
  long substituted_back;
};

FrontCounts count_fronts();

}  // namespace wirewarp
