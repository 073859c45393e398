// SPDX-License-Identifier: GPL-3.0-or-later
// Minimizes the quadratic model of f + λᵀc on the tangent space of the length constraints, in a ball. Unlike Newton
// steps, these steps also work at saddles and along soft modes.
//
//   q(d) = g·d + ½ d·H d   over J d = 0, |d|_G <= Δ
//
// H is the exact Hessian, perhaps indefinite. G, the convex part of H, has a Cholesky factor.
//
// The method is the generalized Lanczos method (N. I. M. Gould, S. Lucidi, M. Roma, Ph. L. Toint, Solving the
// trust-region subproblem using the Lanczos method, SIAM J. Optimization 9 (1999), 504-525). In a basis v_1 … v_k that
// is orthonormal in G, H is a tridiagonal T. Restricted to the span, q is a dense problem of size k, and one basis is
// enough for every radius Δ. Each vector costs one solve with G's factor, at most a tenth of the cost of a
// factorization.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace wirewarp {

struct ModelStep {
  Eigen::VectorXd d;
  double length = 0;       // |d|_G
  double decrease = 0;     // -q(d) > 0
  bool is_inside = false;  // whether d is shorter than the radius, and is therefore a minimum of q
};

class LanczosTrustRegion {
 public:
  using Operator = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

  /// Builds at most max_size basis vectors for the gradient g. Throws FactorizationFailed if a product is not finite.
  ///
  /// - times_hessian(d) returns H d.
  /// - precondition(r) returns the d in the tangent space with G d = r. It may remove components of r normal to this
  ///   space.
  LanczosTrustRegion(const Operator& times_hessian,
                     const std::function<Eigen::VectorXd(Eigen::VectorXd& r)>& precondition,
                     const Eigen::VectorXd& gradient, int max_size);

  /// Returns the |d|_G that the minimum of q would have if H were G.
  double convex_length() const { return first_; }

  int size() const { return static_cast<int>(basis_.size()); }

  /// Returns the least d·Hd over |d|²_G in the span of the basis; 0 if the basis is empty.
  double lowest_curvature() const { return basis_.empty() ? 0 : eigenvalues_[0]; }

  /// Returns the minimum of q in the span and the ball.
  ModelStep step(double radius) const;

  /// Returns the step of length radius along the lowest curvature, as if the gradient were 0.
  ModelStep step_along_lowest_curvature(double radius) const;

 private:
  Eigen::VectorXd combine(const Eigen::VectorXd& coefficients) const;

  double first_ = 0;                    // β₀: g = -β₀ G v₁
  std::vector<Eigen::VectorXd> basis_;  // v
  Eigen::VectorXd eigenvalues_;         // of T
  Eigen::MatrixXd eigenvectors_;
};

}  // namespace wirewarp
