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
  double shape_error = 0;     // E divided by the 3D area
  int iterations = 0;
  int evaluations = 0;          // evaluations of E; all except the evaluation of an unused start include the gradient
  int inner_solves = 0;         // all factorizations of Eq. (1)
  int free_factorizations = 0;  // factorizations of the free flattening that gives h0
  bool converged = true;
};

/// Bounds on h, one per wire part. For rigid parts and boundaries, both bounds are 0.
struct VariationBounds {
  Eigen::VectorXd lower;
  Eigen::VectorXd upper;

  std::vector<int> elastic_parts() const;
};

/// Returns the bounds |h| <= tolerance for elastic parts, and -0.99 <= h <= 100 for super-elastic parts. With
/// WireWarping, the user's wires are rigid, and only the helper wires of the method are free. With Inner::least_norm, h
/// is 0 everywhere, because the least-norm solution has no gradient with respect to h.
VariationBounds variation_bounds(const Chart& chart, const Options& options);

/// Returns h0, the start of the search: the lengths of a free ARAP flattening, clamped to the bounds. h0 is 0 if ψ(0)
/// is better or an isometry, or if no part is elastic. shape.inner is not feasible if neither start leads to a shape.
OuterSolution start_variation(const Chart& chart, Warp& warp, const VariationBounds& bounds);

/// Returns the length variations with the least shape error within the bounds, found from h0. If Eq. (1) has several
/// minima, the wire angles stay on the branch of h0, so that E does not jump. The result is h0, not converged, if the
/// angles at h0 are not a minimum of Eq. (1), because E has no gradient there. The warp's token is also checked before
/// each evaluation.
OuterSolution choose_variation(const Chart& chart, Warp& warp, const VariationBounds& bounds);

}  // namespace wirewarp
