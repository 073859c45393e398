// SPDX-License-Identifier: GPL-3.0-or-later
// Flattens charts with slits. The two rims of a shut slit coincide. At such a shape, the set of shapes with exact
// lengths is not smooth, because two branches cross if the rims are straight. On one branch, the slit stays shut and
// bends to one side or the other. On the other branch, the slit opens, or its rims pass through each other. Where the
// branches cross, the derivatives of the lengths are linearly dependent, and Newton steps cannot change branches.
// Therefore each branch is searched separately, and slits whose rims would pass through each other are sewn:
//
//   1. Sew all slits and find the least distorted shape, which also has the lengths of the open chart.
//   2. From this shape, open all slits a little and minimize.
//   3. Sew the slits whose rims passed through each other, and repeat step 2 until no rims pass through each other.
#pragma once

#include "newton/control.h"
#include "newton/problem.h"
#include "newton/solution.h"

namespace wirewarp {

/// Returns the less distorted of two shapes: the shape of step 1, and the shape after step 3. shut: the exact shape of
/// step 1. The chart must have a slit.
Solution open_slits(Problem& problem, const Stage& stage, const Solution& shut, const Control& control);

}  // namespace wirewarp
