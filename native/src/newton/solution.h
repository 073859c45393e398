// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>

#include "energy/fair_shape_error.h"
#include "wirewarp/types.h"

namespace wirewarp {

/// A flat shape of a chart, or the start of a solver.
struct Shape {
  Positions2 uv;                     // one row per chart vertex, scene units
  Eigen::VectorXd variation = {};    // h, one per wire part of the chart, also of free parts; empty: unknown
  Eigen::VectorXd multipliers = {};  // λ, one per row of the length constraints; empty: unknown or inaccurate
};

/// How an attempt at a flat shape with exact lengths ended.
enum class SolutionStatus {
  infeasible,  // lengths did not become exact from this start, or not before the budget was spent
  singular,    // a matrix had no factor in double precision before lengths were exact
  cancelled,   // the caller stopped before lengths were exact
  stalled,     // exact lengths; another step could reduce f
  converged,   // exact lengths; the predicted decrease of f is below 1e-9 of f, or below rounding errors
};

struct Solution {
  Shape shape;
  SolutionStatus status = SolutionStatus::infeasible;
  std::optional<Injectivity> injectivity;  // empty until computed
  const char* start = "";   // name of the start that led to exact lengths (newton/starts.h); empty if no start did
  double objective = 0;     // f over the 3D area
  double length_error = 0;  // LengthConstraints::largest_error
  int iterations = 0;       // Newton iterations from this start
  int factorizations = 0;   // of these iterations; a Budget counts the factorizations of all starts
  double projected_gradient = std::numeric_limits<double>::quiet_NaN();  // of a coupled group; NaN for a single chart

  /// Returns whether the lengths of the shape are exact.
  bool is_exact() const { return status >= SolutionStatus::stalled; }
  bool is_converged() const { return status == SolutionStatus::converged; }
};

}  // namespace wirewarp
