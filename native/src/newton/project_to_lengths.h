// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "newton/control.h"
#include "newton/problem.h"
#include "wirewarp/types.h"

namespace wirewarp {

inline constexpr int kMaxProjectFactorizations = 30;  // enough for starts near exact lengths; most need fewer than 10

/// Moves uv to exact lengths by Gauss-Newton steps on the lengths alone. Each step is the least change in the metric of
/// the Laplacian; elastic parts may vary within their tolerances. The metric matters if the flat shape has more degrees
/// of freedom than fixed lengths. The tolerances matter if it has fewer. Returns false if exact lengths are not
/// reached; uv then has the smallest length errors that were found. Throws Stopped; the token is polled before each
/// factorization.
bool project_to_lengths(const Problem& problem, Positions2& uv, const Control& control);

}  // namespace wirewarp
