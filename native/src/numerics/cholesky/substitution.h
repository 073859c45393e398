// SPDX-License-Identifier: GPL-3.0-or-later
// Solves with a factor, front by front. Computes L⁻¹ b from the leaves to the roots, then L⁻ᵀ of the result from the
// roots to the leaves. Each of the two shares of subtrees sums its contributions to the rows of the ancestors
// separately. The two sums are added in a fixed order, so the number of threads does not change the result.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "numerics/cholesky/front_kernels.h"
#include "numerics/cholesky/front_layout.h"

namespace wirewarp {

class Substitution {
 public:
  /// layout and kernels must outlive this object.
  Substitution(const FrontLayout& layout, bool in_threads, const FrontKernels& kernels);

  /// Returns the fronts that contain the given vertices, with all their ancestors; others() returns the complement.
  FrontSet fronts_reaching(const std::vector<int>& vertices) const;
  FrontSet others(const FrontSet& fronts) const;
  const FrontSet& all() const { return all_; }

  /// Replaces b by L⁻¹ b. b must be zero except at pivots of the given fronts. factor: the panels of all fronts.
  void forward(const Tile* factor, Eigen::Ref<Eigen::MatrixXd> b, const FrontSet& nonzero) const;
  /// Replaces b by L⁻ᵀ b at pivots of the wanted fronts. If the set does not include all ancestors of these fronts, an
  /// earlier call must have solved for the ancestors.
  void back(const Tile* factor, Eigen::Ref<Eigen::MatrixXd> b, const FrontSet& wanted) const;

 private:
  FrontSet fronts_where(const std::vector<char>& is_visited) const;
  template <int kColumns>
  void forward_4(const Tile* factor, Eigen::Ref<Eigen::MatrixXd> b, const FrontSet& nonzero) const;
  template <int kColumns>
  void back_4(const Tile* factor, Eigen::Ref<Eigen::MatrixXd> b, const FrontSet& wanted) const;

  const FrontLayout& layout_;
  bool in_threads_;
  const FrontKernels& kernels_;
  FrontSet all_;
};

}  // namespace wirewarp
