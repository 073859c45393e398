// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace wirewarp {

/// How often this thread of the test program has taken memory: by operator new, and in Eigen by malloc and its kin.
int num_allocations();

}  // namespace wirewarp
