// SPDX-License-Identifier: GPL-3.0-or-later
// The free-boundary ARAP map of a chart: the local minimum of the shape error E of Eq. (4), without wires or boundary
// lengths. It is found by conjugate gradients. Their preconditioner is a local/global step (L. Liu, L. Zhang, Y. Xu, C.
// Gotsman, S. J. Gortler, A local/global approach to mesh parameterization, Computer Graphics Forum 27 (2008),
// 1495-1504). On long and bent charts, this takes a tenth of the steps of the plain local/global method.
#pragma once

#include <optional>

#include "base/stop_token.h"
#include "surface/charts/chart.h"
#include "wirewarp/types.h"

namespace wirewarp {

struct FreeBoundaryArap {
  Positions2 uv;           // one row per chart vertex, scene units
  double energy = 0;       // E of Eq. (4), scene units squared
  int iterations = 0;      // number of steps, with one solve each
  int factorizations = 0;  // 1, or 2 if the start is the Tutte embedding
  bool converged = false;  // whether the last step lowered E by less than 1e-6 of E
};

/// This number of steps is enough for starts and for the choice of wire lengths. Further steps hardly lower E.
inline constexpr int kFreeSteps = 30;

/// Takes at most max_iterations steps, of which none increases E. Throws Stopped and FactorizationFailed.
///
/// start: one row per chart vertex, mirrored if its area is negative. Default: the Tutte embedding.
FreeBoundaryArap free_boundary_arap(const Chart& chart, int max_iterations, const std::optional<Positions2>& start = {},
                                    const StopToken& stop = {});

}  // namespace wirewarp
