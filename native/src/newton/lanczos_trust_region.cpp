// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/lanczos_trust_region.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "base/factorization_failed.h"

namespace wirewarp {
namespace {

// Off-diagonal entry of T below which the basis spans an invariant space. The next vector would have errors of 1e-10.
constexpr double kExhausted = 1e-6;
constexpr double kSolved = 0.01;  // residual of H d = -g over |g|; more digits are useless, because the next H is new

/// Returns |r| in the norm dual to G, for z = G⁻¹ r. Throws if the norm is not finite, because comparisons treat NaN as
/// small.
double dual_norm(const Eigen::VectorXd& r, const Eigen::VectorXd& z) {
  const double squared = r.dot(z);
  if (!std::isfinite(squared)) throw FactorizationFailed("a gradient or its preconditioner is not finite");
  return std::sqrt(std::max(0.0, squared));
}

}  // namespace

LanczosTrustRegion::LanczosTrustRegion(const Operator& times_hessian,
                                       const std::function<Eigen::VectorXd(Eigen::VectorXd& r)>& precondition,
                                       const Eigen::VectorXd& gradient, int max_size) {
  std::vector<Eigen::VectorXd> dual;  // G v
  std::vector<double> diagonal, beside;
  Eigen::VectorXd r = -gradient;
  Eigen::VectorXd z = precondition(r);
  first_ = dual_norm(r, z);
  double norm = first_;
  double residual = 1;  // residual of H d = -g over |g|, as in conjugate gradients; valid while H is positive
  double pivot = 1;     // pivot of T
  bool is_positive = true;
  while (static_cast<int>(basis_.size()) < max_size && norm > (basis_.empty() ? 0 : kExhausted)) {
    basis_.push_back(z / norm);
    dual.push_back(r / norm);
    r = times_hessian(basis_.back());
    diagonal.push_back(basis_.back().dot(r));
    for (std::size_t j = 0; j < basis_.size(); ++j) r -= basis_[j].dot(r) * dual[j];
    z = precondition(r);
    for (std::size_t j = 0; j < basis_.size(); ++j) {  // orthogonalization is repeated once, which is enough
      const double overlap = dual[j].dot(z);
      z -= overlap * basis_[j];
      r -= overlap * dual[j];
    }
    pivot = diagonal.back() - (beside.empty() ? 0 : beside.back() * beside.back() / pivot);
    norm = dual_norm(r, z);
    is_positive = is_positive && pivot > 0;
    residual *= norm / std::max(pivot, 1e-300);
    if (is_positive && residual < kSolved) break;
    beside.push_back(norm);
  }
  if (basis_.empty()) return;
  const auto size = static_cast<Eigen::Index>(basis_.size());
  Eigen::MatrixXd t = Eigen::MatrixXd::Zero(size, size);
  for (Eigen::Index i = 0; i < size; ++i) {
    t(i, i) = diagonal[static_cast<std::size_t>(i)];
    if (i + 1 < size) t(i, i + 1) = t(i + 1, i) = beside[static_cast<std::size_t>(i)];
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(t);
  eigenvalues_ = eigen.eigenvalues();
  eigenvectors_ = eigen.eigenvectors();
}

/// Finds y(σ) = β₀ (T + σ)⁻¹ e₁ with the smallest σ >= 0 that makes T + σ positive and |y| <= Δ, by bisection on σ.
ModelStep LanczosTrustRegion::step(double radius) const {
  const Eigen::VectorXd force = first_ * eigenvectors_.row(0).transpose();
  const auto solution = [&](double shift) -> Eigen::VectorXd {
    return (force.array() / (eigenvalues_.array() + shift)).matrix();
  };
  ModelStep step;
  Eigen::VectorXd y;
  step.is_inside = eigenvalues_[0] > 0 && solution(0).norm() <= radius;
  if (step.is_inside) {
    y = solution(0);
  } else {
    double low = std::max(0.0, -eigenvalues_[0]);
    double high = low + first_ / radius;  // |y| <= Δ at this σ
    for (int i = 0; i < 60; ++i) {        // a double has 53 bits
      const double middle = (low + high) / 2;
      (solution(middle).norm() > radius ? low : high) = middle;
    }
    y = solution(high);
  }
  step.length = y.norm();
  step.decrease = force.dot(y) - 0.5 * y.dot(eigenvalues_.cwiseProduct(y));
  step.d = combine(eigenvectors_ * y);
  return step;
}

ModelStep LanczosTrustRegion::step_along_lowest_curvature(double radius) const {
  ModelStep step;
  step.length = radius;
  step.decrease = -0.5 * eigenvalues_[0] * radius * radius;
  step.d = combine(radius * eigenvectors_.col(0));
  return step;
}

Eigen::VectorXd LanczosTrustRegion::combine(const Eigen::VectorXd& coefficients) const {
  Eigen::VectorXd d = Eigen::VectorXd::Zero(basis_.front().size());
  for (std::size_t j = 0; j < basis_.size(); ++j) d += coefficients[static_cast<Eigen::Index>(j)] * basis_[j];
  return d;
}

}  // namespace wirewarp
