// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace wirewarp {

/// Returns the number of allocations by this thread so far, with operator new or, as in Eigen, with malloc.
int num_allocations();

}  // namespace wirewarp
