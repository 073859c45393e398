// SPDX-License-Identifier: GPL-3.0-or-later
// Charts with slits. The rims of a shut slit are two chains that end at the same points and lie on one another. At such
// a shape, the set of shapes with exact lengths is not smooth, because two branches cross if the chains are straight.
// On one branch, the slit stays shut and bends to one side or the other. On the other branch, the slit opens, or its
// rims pass through each other. The derivatives of the lengths are dependent there, and Newton steps cannot change
// branches. So each branch is searched by itself, and slits whose rims would pass through each other are sewn:
//
//   1. Sew all slits and find the least distorted shape. It has the lengths of the open chart, too.
//   2. From there, open all slits a little and minimize.
//   3. Sew those again whose rims passed through each other; repeat until none did.
#pragma once

#include <functional>

#include "newton/control.h"
#include "newton/problem.h"
#include "newton/solution.h"

namespace wirewarp {

/// Returns the better one of the shapes of step 1 and of the last step 3; it is not exact if the sewn chart has no flat
/// shape. The chart must have a slit. solve_sewn: finds the least distorted shape of a chart from scratch.
Solution open_slits(Problem& problem, const Stage& stage, const std::function<Solution(Problem& sewn)>& solve_sewn,
                    const Control& control);

}  // namespace wirewarp
