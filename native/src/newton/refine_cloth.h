// SPDX-License-Identifier: GPL-3.0-or-later
// The stage of a cloth. It starts from the least distorted shape without a cloth, which has exact lengths and no
// flipped triangles, turned upright, and minimizes the energy of the cloth in place of E. No step flips a triangle,
// because a cloth has no energy that would flip it back (energy/cloth_law.h).
//
// The energy of a cloth depends on how the piece is turned. One row n·(u_b − u_a) = 0 holds the direction between two
// vertices (upright_pair()). Its multiplier is the slope of the energy by the angle. Under Orientation::best, Newton
// steps by the angle lead to where the slope vanishes, from the best of 36 directions.
#pragma once

#include <optional>

#include "newton/refine_chart.h"
#include "wirewarp/options.h"

namespace wirewarp {

/// Holds the direction that two vertices have in a layout.
inline GrainRow hold_direction(const VertexPair& pair, const Positions2& uv) {
  const Eigen::Vector2d chord = (uv.row(pair[1]) - uv.row(pair[0])).transpose().normalized();
  return {pair[0], pair[1], {chord.y(), -chord.x()}};
}

/// Holds the direction that says how a chart is turned.
GrainRow hold_upright(const Chart& chart, const Positions2& uv, const Options& options);

/// Turns an exact solution of refine_chart() upright, x along the weft, and refines it for options.cloth unless it is
/// flipped. Its multipliers then have one for the row, last. Keeps the shape at hand if the caller stops, if the budget
/// is spent, or if the cloth would flip a triangle or make the piece overlap itself. The cloth's stretch comes later
/// (newton/solve/stretch_charts.h).
void refine_cloth(Problem& problem, const InternalOptions& options, const Control& control, Solution& solution);

/// Solves a chart from scratch, also for the cloth if there is one. Returns an injective shape, or none.
std::optional<Solution> refine_injective(const Chart& chart, const InternalOptions& options, const Control& control);

}  // namespace wirewarp
