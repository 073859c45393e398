// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/charts/chart.h"

namespace wirewarp {

/// Returns g of each wire part in a layout: the flat length divided by the target length at h = ease, minus 1. uv: one
/// row per chart vertex.
Eigen::VectorXd length_variation(const Chart& chart, const Positions2& uv);

/// Returns h of each wire part of the chart. solver: g, one per part; the values of helper wires may follow.
std::vector<double> variations_of(const Chart& chart, const Eigen::VectorXd& solver);

}  // namespace wirewarp
