// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/seen_from_the_side.h"

#include <Eigen/Eigenvalues>

namespace wirewarp {

Positions2 seen_from_the_side(const Positions3& points) {
  const Eigen::MatrixX3d centered = points.rowwise() - points.colwise().mean().eval();
  const Eigen::Matrix3d spread = centered.transpose() * centered;
  return centered * Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().rightCols<2>();
}

}  // namespace wirewarp
