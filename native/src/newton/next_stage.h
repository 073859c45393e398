// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "newton/control.h"
#include "newton/problem.h"
#include "newton/solution.h"

namespace wirewarp {

/// Minimizes from the shape of an earlier stage. Sews all slits that are shut there, because the set of shapes with
/// exact lengths is not smooth where a slit is shut (newton/open_slits.h). If the stage has other lengths and one step
/// does not reach them, tries the method of multipliers if the stage forbids flips.
Solution minimize_next(Problem& problem, const Stage& stage, const Shape& start, const Control& control);

}  // namespace wirewarp
