// SPDX-License-Identifier: GPL-3.0-or-later
// Array types of the public API. They are row-major, so that numpy can view them without a copy.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace wirewarp {

using Positions3 = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;  // n by 3, scene units
using Positions2 = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>;  // n by 2, scene units
using Triangles = Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor>;      // m by 3, vertex indices
using VertexPairs = Eigen::Matrix<int, Eigen::Dynamic, 2, Eigen::RowMajor>;    // k by 2, vertex indices
using CornerUv = Eigen::Matrix<double, Eigen::Dynamic, 6, Eigen::RowMajor>;    // m by (3 corners x 2), scene units
using VertexPair = std::array<int, 2>;

}  // namespace wirewarp
