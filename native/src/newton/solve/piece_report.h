// SPDX-License-Identifier: GPL-3.0-or-later
// What the solvers report about a piece. If they found no shape, that is what they tried.
#pragma once

#include <limits>

#include "newton/refine_chart.h"
#include "warp/outer/choose_variation.h"

namespace wirewarp {

inline constexpr double kNoGradient = std::numeric_limits<double>::quiet_NaN();  // PieceReport::projected_gradient

void report_solution(const OuterSolution& solution, PieceReport& report);

/// factorizations: of all starts of the piece.
void report_refinement(const Solution& solution, int factorizations, bool was_stopped, PieceReport& report);

/// For an exact solution that started from the shape of the report.
void report_next_refinement(const Solution& solution, bool was_stopped, PieceReport& report);

/// For a piece whose elastic seams keep their nominal lengths because nothing better was found. If it was canceled, its
/// report says so already.
void report_fixed_seams(PieceReport& report);

/// For a shape that has exact lengths when the caller stops. Reports this once.
void report_cancelled(PieceReport& report);

}  // namespace wirewarp
