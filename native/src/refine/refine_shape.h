// SPDX-License-Identifier: GPL-3.0-or-later
// The refined method: all vertex positions at once, under exact lengths.
//
//   min f(u)   subject to   c(u, h) = 0,   |h| <= ε on elastic parts
//
// A Newton method on the feasible set. Phase 1 goes from a free flattening to exact lengths, phase 2 along them to the
// minimum. Every iterate of phase 2 has exact lengths, so it can stop at any step.
#pragma once

#include <functional>

#include "refine/newton_system.h"

namespace wirewarp {

struct RefinedSolution {
  Positions2 uv;              // one row per chart vertex, scene units
  Eigen::VectorXd variation;  // h, one per elastic part of the constraints
  double value = 0;           // f, scene units squared
  double length_error = 0;    // largest |c| / l
  int factorizations = 0;
  int solves = 0;
  int iterations = 0;
  bool is_exact = false;   // the lengths are
  bool converged = false;  // the next step promises less than 1e-9 of f
  bool cancelled = false;
};

/// start: a flat shape, one row per chart vertex. go_on: asked before each step; false stops at the iterate at hand.
RefinedSolution refine_shape(const Chart& chart, const WireNetwork& network, double fairness, int max_factorizations,
                             const Positions2& start, const std::function<bool()>& go_on);

}  // namespace wirewarp
