// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace wirewarp {

/// Number of allocations by this thread so far: by operator new, and by malloc and the like, which Eigen calls.
int num_allocations();

}  // namespace wirewarp
