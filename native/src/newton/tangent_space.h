// SPDX-License-Identifier: GPL-3.0-or-later
// The changes of shape (d, Δh) that keep the lengths to first order: J d = T Δh, where h changes only on elastic parts
// that are not at a bound. A vector of this space has x and y of each vertex in turn, then Δh of these parts.
#pragma once

#include <Eigen/Cholesky>
#include <vector>

#include "newton/newton_system.h"

namespace wirewarp {

class TangentSpace {
 public:
  /// The system and the constraints must outlive the space unchanged. Throws FactorizationFailed.
  ///
  /// system: factored with a convex H, here called G
  /// free: elastic parts that are not at a bound
  TangentSpace(const NewtonSystem& system, const LengthConstraints& constraints, std::vector<int> free);

  const std::vector<int>& free() const { return free_; }

  /// Returns the vector (d, Δh) of the space for which r - G (d, Δh) is normal to the space. Removes the components of
  /// the force r that are normal to the space.
  Eigen::VectorXd solve(Eigen::VectorXd& force) const;

  /// Returns a force on the vertices as a vector of the space, with zeros for Δh.
  Eigen::VectorXd force_on_vertices(const Positions2& force) const;

 private:
  const NewtonSystem& system_;
  const LengthConstraints& constraints_;
  std::vector<int> free_;
  Eigen::LLT<Eigen::MatrixXd> factor_h_;  // Cholesky factor of S (newton_system.h) for the free parts
};

}  // namespace wirewarp
