// SPDX-License-Identifier: GPL-3.0-or-later
// The stages of a coupled group, which mostly is one chart, after each chart has a shape by itself.
//
//   1. Elastic seams: all shapes and the common lengths of these seams (newton/refine_coupled.h).
//   2. Stretched lengths: the same again for a cloth that is stretched when it is worn (stretched_lengths.h), in the
//      plane of the stretched cloth (energy/target_lengths.h).
//
// Each stage starts from the shapes of the one before. It fails if it finds no common lengths, or if a chart is flipped
// or overlaps itself with them although all charts were good before: good pieces come before less distortion. Then each
// chart is solved by itself, with its elastic seams fixed at h = ease. If that fails, too, a chart keeps its last good
// shape in stage 1, and its report says so. In stage 2 it gets an error, because its neighbors have stretched lengths.
#pragma once

#include <vector>

#include "newton/solve/solve_chart.h"
#include "newton/solve/stretched_lengths.h"
#include "newton/solved_chart.h"

namespace wirewarp {

/// A chart of a coupled group. solved: its layout from the stage before, upright for a cloth.
struct GroupMember {
  Chart& chart;
  SolvedChart& solved;
  bool is_nominal;     // it has elastic seams, and can be solved with these at h = ease
  PerEdge flat_ratio;  // stage 2: StretchedLengths::ratios
};

/// Stage 1. A chart that has no shape at h = ease and finds no common lengths gets the error that it has at h = ease.
void free_elastic_seams(const std::vector<GroupMember>& group, const Run& run, const StopToken& stop);

/// Stage 2. Layouts become the flat ones, and the stretched lengths become targets of the charts.
void stretch_group(const std::vector<GroupMember>& group, const Run& run, const StopToken& stop);

}  // namespace wirewarp
