// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace wirewarp {

/// Numbers of fronts that all threads of the test program have visited so far in the Cholesky kernels, with up to four
/// right-hand sides per visit. The numbers are the same in every run on one machine. On another machine, rounding
/// errors may end an iteration a step earlier or later.
struct FrontCounts {
  long factored;
  long substituted_forward;
  long substituted_back;
};

FrontCounts count_fronts();

}  // namespace wirewarp
