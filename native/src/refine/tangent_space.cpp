// SPDX-License-Identifier: GPL-3.0-or-later
#include "refine/tangent_space.h"

#include <utility>

namespace wirewarp {

TangentSpace::TangentSpace(const NewtonSystem& system, const LengthConstraints& constraints,
                           const Eigen::MatrixXd& dlambda_dh, std::vector<int> free)
    : system_(system), constraints_(constraints), free_(std::move(free)) {
  if (free_.empty()) return;
  dlambda_dh_ = dlambda_dh(Eigen::all, free_);
  factor_h_.compute(make_positive(hessian_h(constraints.elastic_lengths(), dlambda_dh)(free_, free_)));
}

/// Stationary are G d + Jᵀλ = r_u and -Tᵀλ = r_h. With λ = λ₀ + ∂λ/∂h Δh that is S Δh = r_h + Tᵀλ₀.
Eigen::VectorXd TangentSpace::solve(Eigen::VectorXd& force) const {
  const auto num_free = static_cast<Eigen::Index>(free_.size());
  const Eigen::Index size = force.size() - num_free;
  const Eigen::SparseMatrix<double>& lengths = constraints_.elastic_lengths();
  const Positions2 on_vertices = Eigen::Map<const Positions2>(force.data(), size / 2, 2);
  Eigen::VectorXd result(force.size());
  NewtonSystem::Solution solution = system_.solve_roughly(on_vertices, Eigen::VectorXd::Zero(constraints_.size()));
  Eigen::VectorXd variation = Eigen::VectorXd::Zero(constraints_.num_elastic());
  if (num_free > 0) {
    const Eigen::VectorXd pull = lengths.transpose() * solution.multipliers.col(0);
    result.tail(num_free) = factor_h_.solve(force.tail(num_free) + pull(free_));
    solution.multipliers += dlambda_dh_ * result.tail(num_free);
    variation(free_) = result.tail(num_free);
  }
  system_.improve(lengths * variation, solution);
  const Positions2 d = system_.finish(solution.d);
  result.head(size) = Eigen::Map<const Eigen::VectorXd>(d.data(), size);

  Positions2 normal = Positions2::Zero(size / 2, 2);
  constraints_.add_transposed(system_.directions(), solution.multipliers, normal);
  force.head(size) -= Eigen::Map<const Eigen::VectorXd>(normal.data(), size);
  if (num_free > 0) {
    const Eigen::VectorXd pull = lengths.transpose() * solution.multipliers.col(0);
    force.tail(num_free) += pull(free_);
  }
  return result;
}

Eigen::VectorXd TangentSpace::force_on_vertices(const Positions2& force) const {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(force.size() + static_cast<Eigen::Index>(free_.size()));
  result.head(force.size()) = Eigen::Map<const Eigen::VectorXd>(force.data(), force.size());
  return result;
}

}  // namespace wirewarp
