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
  int evaluations = 0;          // evaluations of E, with gradients except for a start that is not used
  int inner_solves = 0;         // all factorizations of Eq. (1)
  int free_factorizations = 0;  // factorizations of the free flattening that gives h0
  bool converged = true;
};

/// Bounds on h, one per wire part. They are equal for rigid parts and boundaries, where h is 0.
struct VariationBounds {
  Eigen::VectorXd lower;
  Eigen::VectorXd upper;

  std::vector<int> elastic_parts() const;
};

/// Returns the bounds |h| <= tolerance for elastic parts and -0.99 <= h <= 100 for super-elastic ones. WireWarping
/// keeps the user's wires rigid; only its helper wires are free. The least-norm solution has no gradient by h, so h is
/// 0 everywhere.
VariationBounds variation_bounds(const Chart& chart, const Options& options);

/// Returns h0, the start of the search: the lengths of a free ARAP flattening, clamped to the bounds. h0 = 0 if ψ(0) is
/// better or an isometry, or if no part is elastic. shape.inner is not feasible if neither start has a shape.
OuterSolution start_variation(const Chart& chart, Warp& warp, const VariationBounds& bounds);

/// Returns the length variations with the least shape error within the bounds, found from h0; h0 itself if nothing can
/// be improved. The wire angles follow from one h to the next, so that E does not jump if Eq. (1) has several minima.
/// The result is not converged if the angles are not at a minimum of Eq. (1) at h0, because E has no gradient there.
/// The warp's token is also checked before each evaluation.
OuterSolution choose_variation(const Chart& chart, Warp& warp, const VariationBounds& bounds);

}  // namespace wirewarp
