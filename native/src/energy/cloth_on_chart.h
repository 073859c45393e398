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

/// The cloth a chart is cut from; x is its weft, y its warp. With a stretch, the layout is that of the stretched cloth,
/// S u for a flat piece u, S = diag(1 + c_weft, 1 + c_warp): energies do not change and flat lengths are |S⁻¹ d|.
struct ClothOnChart {
  Cloth cloth;
  std::vector<GrainRow> grains;  // one for each connected part
  /// Per edge of the chart: flat length over the flat length without a stretch; empty: 1.
  std::vector<double> flat_ratio;
};

}  // namespace wirewarp
