// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/tangent_space.h"

#include <utility>

#include "base/factorization_failed.h"

namespace wirewarp {

TangentSpace::TangentSpace(const NewtonSystem& system, const LengthConstraints& constraints, std::vector<int> free)
    : system_(system), constraints_(constraints), free_(std::move(free)) {
  if (free_.empty()) return;
  factor_h_.compute(make_positive(system.stiffness_by_variation()(free_, free_)));
  if (factor_h_.info() != Eigen::Success) throw FactorizationFailed("TangentSpace: S is not positive definite");
}

/// Solves G d + Jᵀλ = r_u and -Tᵀλ = r_h, where r_u and r_h are the force on the vertices and on the free parts. First
/// solves S Δh = r_h + Tᵀλ, with the λ of Δh = 0 and the S of newton_system.h. Lengths are kept to seven digits, which
/// is enough before a retraction.
Eigen::VectorXd TangentSpace::solve(Eigen::VectorXd& force) const {
  const auto num_free = static_cast<Eigen::Index>(free_.size());
  const Eigen::Index size = force.size() - num_free;
  const Eigen::SparseMatrix<double>& lengths = constraints_.elastic_lengths();
  const NewtonSystem::Reduced reduced = system_.reduce(Eigen::Map<const Positions2>(force.data(), size / 2, 2),
                                                       Eigen::VectorXd::Zero(constraints_.size()));
  Eigen::VectorXd result(force.size());
  Eigen::VectorXd variation = Eigen::VectorXd::Zero(constraints_.num_elastic());
  if (num_free > 0) {
    result.tail(num_free) = factor_h_.solve(force.tail(num_free) + reduced.pull(free_));
    variation(free_) = result.tail(num_free);
  }
  const NewtonSystem::Solution solution = system_.solve_roughly(reduced, variation);
  result.head(size) = solution.d.head(size);

  Positions2 normal = Positions2::Zero(size / 2, 2);
  constraints_.add_transposed(system_.directions(), solution.multipliers, normal);
  force.head(size) -= Eigen::Map<const Eigen::VectorXd>(normal.data(), size);
  if (num_free > 0) {
    const Eigen::VectorXd pull = lengths.transpose() * solution.multipliers;
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
