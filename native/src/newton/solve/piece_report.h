// SPDX-License-Identifier: GPL-3.0-or-later
// Fills in the report of a piece: iterations, factorizations, termination, objective, start and warnings.
#pragma once

#include "newton/refine_chart.h"
#include "warp/outer/choose_variation.h"

namespace wirewarp {

void report_solution(const OuterSolution& solution, PieceReport& report);

/// Reports a refinement. factorizations: total for all starts of the piece.
void report_refinement(const Solution& solution, int factorizations, bool was_stopped, PieceReport& report);

/// Reports an exact solution that started from the shape that the report describes. Adds the new iterations to the
/// iterations in the report.
void report_next_refinement(const Solution& solution, bool was_stopped, PieceReport& report);

/// Reports that elastic seams keep their nominal lengths because no good shapes with other lengths were found.
void report_fixed_seams(PieceReport& report);

/// Reports that the caller stopped after lengths were exact, unless the report says so already.
void report_cancelled(PieceReport& report);

}  // namespace wirewarp
