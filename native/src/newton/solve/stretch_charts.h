// SPDX-License-Identifier: GPL-3.0-or-later
// The stage of a fabric that is stretched when worn. Without the stretch, every chart has a layout, whose directions
// determine how much shorter each edge is when flat (stretched_lengths.h). With these lengths, each coupled group is
// solved once more (group_solver.h), in the plane of the stretched fabric (energy/target_lengths.h). All charts with a
// layout take part, so that the sides of a seam have one length.
#pragma once

#include <vector>

#include "base/progress_report.h"
#include "newton/solve/solve_chart.h"
#include "newton/solved_chart.h"

namespace wirewarp {

/// solved: upright, without the stretch. Layouts become the flat ones, and the stretched lengths become targets of the
/// charts. Without common lengths of a group, its elastic seams are fixed at h = ease. A chart that has no shape with
/// its lengths then gets an error instead of a layout.
///
/// The energy of a cloth is infinite where a triangle is flipped, so a chart that is flipped without the stretch, or
/// overlaps itself and fails, is solved with the shape error in place of that energy. If this unflips it, the cloth's
/// energy comes next.
void stretch_charts(Charts& charts, const Run& run, ProgressReport& report, std::vector<SolvedChart>& solved);

}  // namespace wirewarp
