// SPDX-License-Identifier: GPL-3.0-or-later
// The stretch that a cloth has when it is worn (Cloth::stretch). Without it every chart has a layout, in which each
// edge has a direction: with ψ its angle from the weft, its flat length shrinks to
//
//   L = l √(cos²ψ / (1 + c_weft)² + sin²ψ / (1 + c_warp)²),
//
// by the mean of its sides' shares on a seam, so that mates stay equal. An edge with an ease of its own keeps that.
// From there the charts are solved on with these lengths, in the plane of the stretched cloth (refine/refine_task.h).
#pragma once

#include <vector>

#include "charts_progress.h"
#include "solve_chart.h"
#include "solved_chart.h"

namespace wirewarp {

/// solved: upright, without the stretch; then flat pieces with it, and a warning where the sides of a seam would have
/// shrunk by different shares. charts: ask for the flat lengths from then on. The lengths of elastic seams are found
/// anew, in the same ways (couple_charts.h). Charts without a layout or turned over are left alone, which have an
/// error as they are; another one without a shape for the flat lengths, or stopped before it has it, loses its layout
/// to an error.
void stretch_charts(Charts& charts, const Run& run, ChartsProgress& progress, std::vector<SolvedChart>& solved);

}  // namespace wirewarp
