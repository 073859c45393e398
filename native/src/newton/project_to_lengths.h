// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "newton/control.h"
#include "newton/problem.h"
#include "wirewarp/types.h"

namespace wirewarp {

inline constexpr int kMaxProjectFactorizations = 30;  // enough for starts near exact lengths; most need fewer than 10

/// Moves uv to lengths within the tolerances, by least changes in the metric of the Laplacian. Returns false if uv only
/// comes nearer. Throws Stopped; the token is polled before each factorization.
bool project_to_lengths(const Problem& problem, Positions2& uv, const Control& control);

}  // namespace wirewarp
