// SPDX-License-Identifier: GPL-3.0-or-later
// The outer problem: min E(ψ(h)) over |h| <= ε (paper II-B, Eq. 3).
#pragma once

#include <functional>
#include <vector>

#include "warp/outer/warp.h"

namespace wirewarp {

struct OuterSolution {
  WarpedShape shape;          // ψ(h)
  Eigen::VectorXd variation;  // h, one per wire part
  double shape_error = 0;     // E over the 3D area
  int iterations = 0;
  int evaluations = 0;          // of E; with its gradient but for a start that was not taken
  int inner_solves = 0;         // factorizations of Eq. (1) in all
  int free_factorizations = 0;  // of the free flattening that h0 is taken from
  bool converged = true;
};

/// Bounds on h, one per wire part; equal where h is 0: on rigid parts and boundaries.
struct VariationBounds {
  Eigen::VectorXd lower;
  Eigen::VectorXd upper;

  std::vector<int> elastic_parts() const;
};

/// |h| <= tolerance on elastic parts, and -0.99 <= h <= 100 on all, super-elastic ones among them. WireWarping keeps
/// the user's wires rigid and leaves only the helper wires free. The least-norm solution has no gradient by h: there h
/// is 0 everywhere.
VariationBounds variation_bounds(const Chart& chart, const Options& options);

/// h0, where the search begins: the lengths of a free ARAP flattening within the bounds, or h = 0 where ψ(0) is better,
/// is an isometry, or no part is elastic. shape.inner is not feasible where neither exists.
OuterSolution start_variation(const Chart& chart, Warp& warp, const VariationBounds& bounds);

/// The length variations with the least shape error within the bounds, found from h0; h0 itself where there is nothing
/// to improve. The wire angles follow from one h to the next, so that E does not jump where Eq. (1) has several minima.
/// Not converged where they reach no minimum at h0: E has no gradient there. The warp's token is checked before each
/// evaluation, too.
OuterSolution choose_variation(const Chart& chart, Warp& warp, const VariationBounds& bounds);

}  // namespace wirewarp
