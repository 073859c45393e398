// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "newton/control.h"
#include "newton/problem.h"
#include "newton/solution.h"

namespace wirewarp {

/// Minimizes like minimize(), with those slits sewn that are shut at the start, because shapes with rims on one another
/// are not smooth points (newton/open_slits.h).
Solution minimize_with_shut_slits(Problem& problem, const Stage& stage, const Shape& start, const Control& control);

}  // namespace wirewarp
