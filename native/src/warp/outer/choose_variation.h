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

/// Bounds on h, one per wire part. For rigid parts and for boundaries of fixed length, both bounds are 0.
struct VariationBounds {
  Eigen::VectorXd lower;
  Eigen::VectorXd upper;

  std::vector<int> elastic_parts() const;
};

/// Returns the bounds |h| <= tolerance, limited to -0.99 <= h <= 100. h is 0 with Inner::least_norm, and for wires of
/// the user with Method::wirewarping.
VariationBounds variation_bounds(const Chart& chart, const Options& options);

/// Returns the start h0: the changes of length in a free ARAP flattening, clamped to the bounds. h0 is 0 if ψ(0) is
/// better or an isometry. If no shape is found, `shape.inner.is_feasible` of the result is false.
OuterSolution start_variation(const Chart& chart, Warp& warp, const VariationBounds& bounds);

/// Returns the h with the least shape error within the bounds, on h0's branch of minima of Eq. (1). If the angles of h0
/// are not a minimum, returns h0 as not converged.
OuterSolution choose_variation(const Chart& chart, Warp& warp, const VariationBounds& bounds);

}  // namespace wirewarp
