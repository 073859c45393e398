// SPDX-License-Identifier: GPL-3.0-or-later
// The refined method for a cloth. It begins at the least distorted shape without a cloth, which has exact lengths and
// turns no triangle over, stands it upright, and goes on from there with the energy of the cloth in the place of E: all
// starts, slits and coarser meshes are behind it by then. No step turns a triangle over: there a cloth has no energy
// that would bring it back (cloth/cloth_law.h).
//
// The energy of a cloth depends on how the piece is turned. One row n·(u_b − u_a) = 0 keeps the direction between two
// vertices (upright_pair()). Under Orientation::best there is none: of 36 directions of the shape without a cloth,
// those in which the energy is least are starts, and the best end is the result.
#pragma once

#include "refine/refine_chart.h"
#include "wirewarp/options.h"

namespace wirewarp {

/// result: the shape of refine_chart(), exact; upright afterwards, x along the weft, and refined for options.cloth
/// unless it has triangles turned over. Where the caller stops or the factorizations of options are spent, the shape at
/// hand.
void refine_cloth(const Chart& chart, const InternalOptions& options, const StopToken& stop, RefineResult& result);

}  // namespace wirewarp
