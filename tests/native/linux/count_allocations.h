// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace wirewarp {

/// Returns the number of allocations by this thread so far: with operator new, and with malloc and similar functions,
/// which Eigen calls.
int num_allocations();

}  // namespace wirewarp
