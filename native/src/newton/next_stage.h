// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "newton/control.h"
#include "newton/problem.h"
#include "newton/solution.h"

namespace wirewarp {

/// Minimizes from the shape of an earlier stage. Sews slits that are shut in this shape, because the set of exact
/// shapes is not smooth there. If flips are forbidden, tries injective_start() after a failure.
Solution minimize_next(Problem& problem, const Stage& stage, const Shape& start, const Control& control);

}  // namespace wirewarp
