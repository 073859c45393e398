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

/// Returns a row that keeps the direction between two vertices of a layout.
inline GrainRow hold_direction(const VertexPair& pair, const Positions2& uv) {
  const Eigen::Vector2d chord = (uv.row(pair[1]) - uv.row(pair[0])).transpose().normalized();
  return {pair[0], pair[1], {chord.y(), -chord.x()}};
}

/// Returns a row that keeps the chart from turning.
GrainRow hold_upright(const Chart& chart, const Positions2& uv, const Options& options);

/// Turns an exact solution of refine_chart() upright, with x along the weft, and refines it for options.cloth unless it
/// is flipped. The last one of its multipliers belongs to the row. Keeps the current shape if the caller stops, if the
/// budget is spent, or if the fabric would flip a triangle or make the piece overlap itself. The fabric's stretch comes
/// later (newton/solve/stretch_charts.h).
void refine_cloth(Problem& problem, const InternalOptions& options, const Control& control, Solution& solution);

/// Solves a chart from scratch, for the fabric if there is one. Returns an injective shape, or none.
std::optional<Solution> refine_injective(const Chart& chart, const InternalOptions& options, const Control& control);

}  // namespace wirewarp
