// SPDX-License-Identifier: GPL-3.0-or-later
// Finds which lengths have to change if they contradict one another: every change of a length has a cost.
//
//   Φ(u, h) = f(u) + Σ_g W_g L_g (√(m_g + σ²) − σ) + Σ_w V L_w (√(x_w² + σ²) − σ)
//
//   r_e = |d_e| / l_e − 1 − h_w   strain of an edge beyond the shared variation h of its wire part;
//                                 for a part of one edge, beyond its tolerance
//   m_g                           mean of r² over a group g of length L_g: a wire part, or an edge of the boundary
//   x_w = |h_w| − ε_w or 0        how far a wire part goes beyond its tolerance
//
// For small σ these are sums of magnitudes, so that few lengths change and most are kept (the group lasso: M. Yuan, Y.
// Lin, Journal of the Royal Statistical Society B 68 (2006), 49-67). A larger tolerance reduces x, only a free wire
// makes m zero, and boundary edges change last: V << W of parts << W of the boundary. The method is reweighted least
// squares: for given weights, every term is a spring, and the Newton system already contains springs.
#pragma once

#include "newton/control.h"
#include "newton/problem.h"
#include "wirewarp/types.h"

namespace wirewarp {

inline constexpr int kMaxRelaxFactorizations = 60;  // maximum for all values of σ together

struct RelaxedShape {
  Positions2 uv;                        // one row per chart vertex, scene units
  Eigen::VectorXd tolerance_violation;  // |x|, one per wire part of the chart
  Eigen::VectorXd strain_rms;           // √m, one per wire part; 0 for parts of one edge
  double outline_strain = 0;            // largest √m of a boundary edge
};

/// Minimizes Φ from a start, one row per chart vertex. Throws Stopped; the token is polled before each factorization.
RelaxedShape relax_lengths(const Problem& problem, const Positions2& start, const Control& control);

}  // namespace wirewarp
