// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "wirewarp/cloth.h"
#include "wirewarp/types.h"

namespace wirewarp {

/// Fixes the rotation of a layout: normal · (u_b − u_a) = 0.
struct GrainRow {
  int a, b;  // chart vertices
  Eigen::Vector2d normal;
};

/// The flat lengths of a chart whose layout has a fixed direction. x is the weft of a fabric, y its warp.
///
/// If the fabric is stretched by the shares c when worn, the layout is S u:
///   u   flat piece
///   S   diag(1 + c_weft, 1 + c_warp)
struct TargetLengths {
  std::vector<GrainRow> grains;         // one for each connected part
  std::vector<double> ratio;            // per edge of the chart: flat length over nominal length; empty: all 1
  Eigen::RowVector2d flat_share{1, 1};  // the diagonal of S⁻¹
};

/// Returns the diagonal of S⁻¹.
inline Eigen::RowVector2d flat_share(const Cloth& cloth) {
  return {1 / (1 + cloth.stretch[0]), 1 / (1 + cloth.stretch[1])};
}

}  // namespace wirewarp
