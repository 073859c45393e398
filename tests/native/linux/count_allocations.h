// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace wirewarp {

/// Returns the number of allocations by this thread so far. It counts operator new and also malloc and similar
/// functions, which Eigen calls.
int num_allocations();

}  // namespace wirewarp
