// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace wirewarp {

/// Starts a new measurement of the peak of this process's resident memory (Linux).
void reset_peak_memory();

/// Returns the peak since the last reset, megabytes.
double peak_memory_mb();

}  // namespace wirewarp
