// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace wirewarp {

/// Starts a new measurement of the peak of this process's resident memory. Works on Linux only.
void reset_peak_memory();

/// Returns the peak since the last call of reset_peak_memory(), megabytes.
double peak_memory_mb();

}  // namespace wirewarp
