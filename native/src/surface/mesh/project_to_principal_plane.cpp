// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/mesh/project_to_principal_plane.h"

#include <Eigen/Eigenvalues>

namespace wirewarp {

Positions2 project_to_principal_plane(const Positions3& points) {
  const Eigen::MatrixX3d centered = points.rowwise() - points.colwise().mean().eval();
  const Eigen::Matrix3d spread = centered.transpose() * centered;
  return centered * Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().rightCols<2>();
}

}  // namespace wirewarp
