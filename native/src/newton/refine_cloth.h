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

/// Turns an exact solution, found without a fabric, upright: x is along the weft. Refines the solution for
/// options.cloth unless it is flipped. The last multiplier belongs to the constraint on the direction. Keeps the
/// upright shape if the caller stops, if the budget is spent, or if the piece would overlap itself. The fabric's
/// stretch is applied later (newton/solve/stretch_charts.h).
void refine_cloth(Problem& problem, const InternalOptions& options, const Control& control, Solution& solution);

}  // namespace wirewarp
