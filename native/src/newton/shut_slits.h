// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "newton/control.h"
#include "newton/problem.h"
#include "newton/solution.h"

namespace wirewarp {

/// Calls minimize() with all slits sewn that are shut at the start, because the set of shapes with exact lengths is not
/// smooth where a slit is shut (newton/open_slits.h).
Solution minimize_with_shut_slits(Problem& problem, const Stage& stage, const Shape& start, const Control& control);

}  // namespace wirewarp
