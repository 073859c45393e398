// SPDX-License-Identifier: GPL-3.0-or-later
#include "warp/inner/kkt_system.h"

#include <utility>

#include "base/factorization_failed.h"
#include "warp/inner/elimination_order.h"

namespace wirewarp {
namespace {

/// δ divided by the scale of its closure. Linearly dependent closures (x or y of a slit of one edge) have a pivot of
/// rounding errors, about 1e-16 of the scale. δ determines the sign of this pivot.
constexpr double kRegularization = 1e-13;

}  // namespace

KktSystem::KktSystem(const Eq1& eq1, const WireNetwork& network, StopToken stop)
    : num_edges_(eq1.num_edges()),
      num_closures_(eq1.num_closures()),
      stop_(std::move(stop)),
      order_(num_edges_ + num_closures_) {
  const std::vector<int> order = order_elimination(eq1, network);
  for (int i = 0; i < num_edges_ + num_closures_; ++i) order_.indices()[order[static_cast<std::size_t>(i)]] = i;
}

bool KktSystem::factor(const Eigen::SparseMatrix<double>& laplacian, const Eigen::VectorXd& diagonal,
                       const Eigen::SparseMatrix<double>& jacobian) {
  using Iterator = Eigen::SparseMatrix<double>::InnerIterator;
  stop_.check();
  const Eigen::VectorXd weight = laplacian.diagonal();
  const double mean_diagonal = weight.mean();
  // Scale of J W⁻¹ Jᵀ, where W is the Laplacian's diagonal. x and y of a loop have a common scale, because for a slit
  // along an axis, one of them has only rounding errors.
  Eigen::VectorXd loop_scale = Eigen::VectorXd::Zero(num_closures_ / 2);
  const Eigen::VectorXi& position = order_.indices();
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(static_cast<std::size_t>(laplacian.nonZeros() + jacobian.nonZeros() + num_closures_));
  for (int e = 0; e < num_edges_; ++e) {
    const int column = position[e];
    for (Iterator it(laplacian, e); it; ++it) {
      const int row = position[it.row()];
      if (row < column) entries.emplace_back(row, column, it.value());
      if (row == column) entries.emplace_back(row, row, it.value() + diagonal[e] + (e == 0 ? mean_diagonal : 0));
    }
    // A closure comes after its edges in the order, so the entry is in the upper triangle.
    for (Iterator it(jacobian, e); it; ++it) {
      entries.emplace_back(column, position[num_edges_ + static_cast<int>(it.row())], it.value());
      loop_scale[it.row() / 2] += it.value() * it.value() / weight[e];
    }
  }
  for (int i = 0; i < num_closures_; ++i) entries.emplace_back(position[num_edges_ + i], position[num_edges_ + i], 0.0);
  matrix_.resize(num_edges_ + num_closures_, num_edges_ + num_closures_);
  matrix_.setFromTriplets(entries.begin(), entries.end());

  Eigen::SparseMatrix<double> regularized = matrix_;
  for (int i = 0; i < num_closures_; ++i) {
    regularized.coeffRef(position[num_edges_ + i], position[num_edges_ + i]) = -kRegularization * loop_scale[i / 2];
  }
  if (num_factorizations_ == 0) factor_.analyzePattern(regularized);
  factor_.factorize(regularized);
  ++num_factorizations_;
  return factor_.info() == Eigen::Success && (factor_.vectorD().array() > 0).count() == num_edges_;
}

KktSystem::Solution KktSystem::solve(const Eigen::VectorXd& r1, const Eigen::VectorXd& r2) const {
  if (factor_.info() != Eigen::Success) throw FactorizationFailed("KktSystem: a pivot is zero");
  constexpr int kRefinements = 2;  // each reduces the error by the factor δ / (curvature of the solved closures)
  Eigen::VectorXd right(num_edges_ + num_closures_);
  right << r1, r2;
  right = order_ * right;
  Eigen::VectorXd solution = factor_.solve(right);
  for (int i = 0; i < kRefinements; ++i) {
    solution += factor_.solve(right - matrix_.selfadjointView<Eigen::Upper>() * solution);
  }
  solution = order_.transpose() * solution;
  return {solution.head(num_edges_), solution.tail(num_closures_)};
}

}  // namespace wirewarp
