// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "newton/control.h"
#include "newton/problem.h"
#include "newton/solution.h"

namespace wirewarp {

/// Does what minimize() does, with the slits sewn that the start has shut: shapes with rims that lie on one another are
/// not smooth points (newton/open_slits.h).
Solution minimize_with_shut_slits(Problem& problem, const Stage& stage, const Shape& start, const Control& control);

}  // namespace wirewarp
