// SPDX-License-Identifier: GPL-3.0-or-later
// What the solvers report about a piece. If they found no shape, that is what they tried.
#pragma once

#include "newton/refine_chart.h"
#include "warp/outer/choose_variation.h"

namespace wirewarp {

void report_solution(const OuterSolution& solution, PieceReport& report);

/// factorizations: of all starts of the piece.
void report_refinement(const Solution& solution, int factorizations, bool was_stopped, PieceReport& report);

/// For an exact solution that started from the shape of the report.
void report_next_refinement(const Solution& solution, bool was_stopped, PieceReport& report);

/// For a piece whose elastic seams keep their nominal lengths because nothing better was found.
void report_fixed_seams(PieceReport& report);

/// Of a shape that has exact lengths when the caller stops.
void report_cancelled(PieceReport& report);

}  // namespace wirewarp
