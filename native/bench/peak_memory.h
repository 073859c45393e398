// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace wirewarp {

/// Starts a new measurement of the peak of this process's resident memory. Works on Linux only.
void reset_peak_memory();

/// Returns the peak of this process's resident memory since the last reset_peak_memory(), in megabytes.
double peak_memory_mb();

}  // namespace wirewarp
