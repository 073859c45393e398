// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/internal_options.h"
#include "surface/network/wire_network.h"
#include "wirewarp/cloth.h"

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

/// A chart to refine, with what f and the lengths depend on.
struct RefineTask {
  const Chart& chart;
  const HeldNetwork& network;
  double fairness;                      // shortest unpenalized wavelength of wires, over the square root of the area
  const ClothOnChart* cloth = nullptr;  // null: f contains the shape error of Eq. (4)
  Target target = Target::minimum;
};

}  // namespace wirewarp
