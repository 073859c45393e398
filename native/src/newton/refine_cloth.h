// SPDX-License-Identifier: GPL-3.0-or-later
// The stage for a fabric. It starts from the least distorted shape without a fabric, which has exact lengths and no
// flipped triangles. It turns this shape upright, and minimizes the fabric's energy instead of the shape error. No step
// flips a triangle, because the fabric's energy would not flip the triangle back (energy/cloth_law.h).
//
// The energy of a fabric depends on the rotation of the piece. One constraint n·(u_b − u_a) = 0 fixes the direction
// between two vertices (upright_pair()). Its multiplier is the derivative of the energy with respect to the angle. With
// Orientation::best, several fixed angles are tried. From the best of these angles, Newton's method finds the angle at
// which this derivative is 0.
#pragma once

#include "base/internal_options.h"
#include "newton/control.h"
#include "newton/problem.h"
#include "newton/solution.h"
#include "wirewarp/options.h"

namespace wirewarp {

/// Returns a constraint that keeps the direction between two vertices of a layout.
inline GrainRow hold_direction(const VertexPair& pair, const Positions2& uv) {
  const Eigen::Vector2d chord = (uv.row(pair[1]) - uv.row(pair[0])).transpose().normalized();
  return {pair[0], pair[1], {chord.y(), -chord.x()}};
}

/// Returns a constraint that keeps the chart from rotating.
GrainRow hold_upright(const Chart& chart, const Positions2& uv, const Options& options);

/// Turns an exact solution upright, and refines it for options.cloth. Keeps the upright shape if it is flipped or
/// refining fails. A refined shape has one more multiplier, for the fixed direction.
void refine_cloth(Problem& problem, const InternalOptions& options, const Control& control, Solution& solution);

}  // namespace wirewarp
