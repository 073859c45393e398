// SPDX-License-Identifier: GPL-3.0-or-later
// The least distorted flat shape of a chart that no wire and no boundary holds: the local minimum of the shape error
// E of Eq. (4), found by local/global steps (L. Liu, L. Zhang, Y. Xu, C. Gotsman, S. J. Gortler, A local/global
// approach to mesh parameterization, Computer Graphics Forum 27 (2008), 1495-1504), made conjugate to each other. Long
// and bent charts take a tenth of the steps that way.
#pragma once

#include <optional>

#include "base/stop_token.h"
#include "surface/charts/chart.h"
#include "wirewarp/types.h"

namespace wirewarp {

struct FreeBoundaryArap {
  Positions2 uv;           // one row per chart vertex, scene units
  double energy = 0;       // E of Eq. (4), scene units squared
  int iterations = 0;      // steps: a solution of the factored system each
  int factorizations = 0;  // 1, and 1 more for the embedding on a circle
  bool converged = false;  // the last step lowered E by less than 1e-6 of it
};

/// Enough for lengths and a start: the rest of the way lowers E by little.
inline constexpr int kFreeSteps = 30;

/// Takes at most max_iterations steps from the given layout (one row per chart vertex; mirrored if its area is
/// negative) or, without one, from the embedding on a circle. No step raises E. Throws Stopped, asking before each
/// step, and FactorizationFailed where rounding leaves the Laplacian, or the springs of the embedding, not positive
/// definite.
FreeBoundaryArap free_boundary_arap(const Chart& chart, int max_iterations, const std::optional<Positions2>& start = {},
                                    const StopToken& stop = {});

}  // namespace wirewarp
