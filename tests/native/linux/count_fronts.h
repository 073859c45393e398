// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace wirewarp {

/// Numbers of fronts that the Cholesky kernels have visited so far, in all threads. A visit handles up to four
/// right-hand sides. The numbers depend on the machine, because of rounding errors.
struct FrontCounts {
  long factored;
  long substituted_forward;
  long substituted_back;
};

FrontCounts count_fronts();

}  // namespace wirewarp
