// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "newton/control.h"
#include "newton/problem.h"
#include "newton/solution.h"

namespace wirewarp {

/// Minimizes from the shape of an earlier stage. Sews all slits that are shut in this shape, because the set of shapes
/// with exact lengths is not smooth where a slit is shut (newton/open_slits.h). The first step can fail to reach exact
/// lengths. If the stage forbids flips and the start has none, the method of multipliers is then tried
/// (newton/injective_start.h).
Solution minimize_next(Problem& problem, const Stage& stage, const Shape& start, const Control& control);

}  // namespace wirewarp
