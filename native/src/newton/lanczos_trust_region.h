// SPDX-License-Identifier: GPL-3.0-or-later
// Steps that neither a saddle nor a soft mode can spoil: the quadratic model of f + λᵀc on the tangent space of the
// length constraints, minimized in a ball.
//
//   q(d) = g·d + ½ d·H d   over J d = 0, |d|_G <= Δ      H exact and perhaps indefinite, G a convex part of it,
//   factored
//
// The generalized Lanczos method (N. I. M. Gould, S. Lucidi, M. Roma, Ph. L. Toint, Solving the trust-region subproblem
// using the Lanczos method, SIAM J. Optimization 9 (1999), 504-525): in a basis v_1 … v_k that is orthonormal in G, H
// is a tridiagonal T, and q restricted to its span is a dense problem of size k, solved for every radius Δ from the
// same basis. A step of the Krylov space costs one solve with G's factor, a tenth of a factorization or less.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace wirewarp {

struct ModelStep {
  Eigen::VectorXd d;
  double length = 0;       // |d|_G
  double decrease = 0;     // -q(d) > 0
  bool is_inside = false;  // the ball does not hold it back: a minimum of q
};

class LanczosTrustRegion {
 public:
  using Operator = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

  /// times_hessian: H d. precondition: r ↦ the d in the tangent space with G d = r but for normal components, which it
  /// may take off r. gradient: g. Builds at most max_size basis vectors.
  /// Throws FactorizationFailed where a product is not finite.
  LanczosTrustRegion(const Operator& times_hessian,
                     const std::function<Eigen::VectorXd(Eigen::VectorXd& r)>& precondition,
                     const Eigen::VectorXd& gradient, int max_size);

  /// |d|_G of the step for H = G.
  double convex_length() const { return first_; }

  int size() const { return static_cast<int>(basis_.size()); }

  /// Least d·Hd over |d|²_G in the span; 0 if it is empty.
  double lowest_curvature() const { return basis_.empty() ? 0 : eigenvalues_[0]; }

  /// The minimum of q in the span and the ball.
  ModelStep step(double radius) const;

  /// A step of length radius along the lowest curvature, as if there were no gradient.
  ModelStep step_along_lowest_curvature(double radius) const;

 private:
  Eigen::VectorXd combine(const Eigen::VectorXd& coefficients) const;

  double first_ = 0;                    // β₀: g = -β₀ G v₁
  std::vector<Eigen::VectorXd> basis_;  // v
  Eigen::VectorXd eigenvalues_;         // of T
  Eigen::MatrixXd eigenvectors_;
};

}  // namespace wirewarp
