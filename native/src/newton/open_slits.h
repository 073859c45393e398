// SPDX-License-Identifier: GPL-3.0-or-later
// Charts with slits. The rims of a shut slit are two chains that end at the same points and lie on one another. Such a
// shape is no smooth point of the shapes with exact lengths: where the chains are straight, those with a shut slit,
// bent to one side or the other, cross those where it opens or its rims go through each other, and the lengths have
// dependent derivatives. Newton steps cannot turn from one branch into the other. So each branch is gone along by
// itself, and what must not go through each other is contact, held by sewing:
//
//   1. all slits sewn: the least distorted shape of a chart without them. It has the lengths of the open one too.
//   2. from there, all slits opened a little.
//   3. those whose rims went through each other sewn again, until none is left.
#pragma once

#include <functional>

#include "newton/control.h"
#include "newton/problem.h"
#include "newton/solution.h"

namespace wirewarp {

/// Returns the better one of the shapes of step 1 and of the last step 3, not exact if the sewn chart has no flat
/// shape. The chart has one slit or more. solve_sewn: finds the least distorted shape of a chart from scratch.
Solution open_slits(Problem& problem, const Stage& stage, const std::function<Solution(Problem& sewn)>& solve_sewn,
                    const Control& control);

}  // namespace wirewarp
