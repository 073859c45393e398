// SPDX-License-Identifier: GPL-3.0-or-later
// The refined method for a cloth. It begins at the least distorted shape without a cloth, which has exact lengths and
// turns no triangle over, stands it upright, and goes on from there with the energy of the cloth in the place of E: all
// starts, slits and coarser meshes are behind it by then. No step turns a triangle over: there a cloth has no energy
// that would bring it back (energy/cloth_law.h).
//
// The energy of a cloth depends on how the piece is turned. One row n·(u_b − u_a) = 0 holds the direction between two
// vertices (upright_pair()). Its multiplier is the slope of the energy by the angle; under Orientation::best Newton
// steps by the angle lead to where it vanishes, from the best of 36 directions.
#pragma once

#include <optional>

#include "newton/refine_chart.h"
#include "wirewarp/options.h"

namespace wirewarp {

inline Cloth without_stretch(Cloth cloth) {
  cloth.stretch = {0, 0};
  return cloth;
}

/// Holds the direction that two vertices have in a layout.
inline GrainRow hold_direction(const VertexPair& pair, const Positions2& uv) {
  const Eigen::Vector2d chord = (uv.row(pair[1]) - uv.row(pair[0])).transpose().normalized();
  return {pair[0], pair[1], {chord.y(), -chord.x()}};
}

/// The direction that says how a chart is turned.
GrainRow hold_upright(const Chart& chart, const Positions2& uv, const Options& options);

/// result: the shape of refine_chart(), exact; upright afterwards, x along the weft, and refined for options.cloth
/// unless it is flipped; its multipliers then have one for the row, last. Where the caller stops, the
/// budget is spent, or the cloth would flip a triangle or make the piece overlap itself, the shape
/// at hand. The cloth's stretch comes later (group_stage.h).
void refine_cloth(const Chart& chart, const InternalOptions& options, RefineBudget& budget, const StopToken& stop,
                  RefineResult& result);

/// From scratch, for the cloth too if there is one: an injective shape, or none.
std::optional<RefineResult> refine_injective(const Chart& chart, const InternalOptions& options, RefineBudget& budget,
                                             const StopToken& stop);

}  // namespace wirewarp
