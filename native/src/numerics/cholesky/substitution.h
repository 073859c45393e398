// SPDX-License-Identifier: GPL-3.0-or-later
// Solutions with a factor, front by front: L⁻¹ b from the leaves up, then L⁻ᵀ of that from the roots down. What the
// two shares of subtrees add to the rows of their ancestors is summed apart and then in a fixed order, so that it does
// not matter how many threads there are.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "numerics/cholesky/front_kernels.h"
#include "numerics/cholesky/front_layout.h"

namespace wirewarp {

class Substitution {
 public:
  /// layout, kernels: must outlive this.
  Substitution(const FrontLayout& layout, bool in_threads, const FrontKernels& kernels);

  /// The fronts that hold some vertices, and all their ancestors; and all that are not among some.
  FrontSet fronts_reaching(const std::vector<int>& vertices) const;
  FrontSet others(const FrontSet& fronts) const;
  const FrontSet& all() const { return all_; }

  /// b := L⁻¹ b, where b is zero but at pivots of some fronts. factor: the panels of all fronts.
  void forward(const Tile* factor, Eigen::Ref<Eigen::MatrixXd> b, const FrontSet& nonzero) const;
  /// b := L⁻ᵀ b at pivots of the wanted fronts, whose ancestors are among them or have been visited before.
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
