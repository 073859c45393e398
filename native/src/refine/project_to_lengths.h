// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "refine/refine_budget.h"
#include "refine/refine_task.h"
#include "stop_token.h"
#include "wirewarp/types.h"

namespace wirewarp {

inline constexpr int kMaxProjectFactorizations = 30;

/// Moves uv to exact lengths by Gauss-Newton steps that look at nothing else: each the least change in the metric of
/// the Laplacian, with whatever variations of the elastic parts within their tolerances it takes. Those matter where
/// more lengths are held than a flat shape has freedom. False where no exact lengths are near: uv is then where the
/// lengths are least off. Throws Stopped, asking before each factorization.
bool project_to_lengths(const RefineTask& task, Positions2& uv, RefineBudget& budget, const StopToken& stop = {});

}  // namespace wirewarp
