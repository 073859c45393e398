// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/internal_options.h"
#include "surface/network/wire_network.h"
#include "wirewarp/cloth.h"

namespace wirewarp {

/// Keeps a layout from turning: normal · (u_b − u_a) = 0.
struct GrainRow {
  int a, b;  // chart vertices
  Eigen::Vector2d normal;
};

/// The cloth a chart is cut from; x is its weft, y its warp. With a stretch the layout is that of the stretched cloth,
/// S u for a flat piece u, S = diag(1 + c_weft, 1 + c_warp): energies are as without a stretch, flat lengths |S⁻¹ d|.
struct ClothOnChart {
  Cloth cloth;
  std::vector<GrainRow> grains;    // one a connected part
  std::vector<double> flat_ratio;  // per edge of the chart: the flat length over that without a stretch; none: 1
};

/// A chart to refine: what f and the lengths are made of.
struct RefineTask {
  const Chart& chart;
  const HeldNetwork& network;
  double fairness;                      // shortest wiggle of wires that is left alone, over the square root of the area
  const ClothOnChart* cloth = nullptr;  // null: f has the shape error of Eq. (4)
  Target target = Target::minimum;
};

}  // namespace wirewarp
