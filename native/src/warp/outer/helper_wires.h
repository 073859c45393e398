// SPDX-License-Identifier: GPL-3.0-or-later
// Lists the wires that topology processing added (paper III), for the report.
#pragma once

#include <vector>

#include "surface/charts/chart.h"

namespace wirewarp {

/// A helper wire and the rows of its points in a layout.
struct PlacedHelperWire {
  HelperWire wire;            // points_2d is empty until place_helper_wires()
  std::vector<int> vertices;  // vertices of the prepared chart
};

/// Returns the wire parts of a prepared chart from first_part on, which are its helper wires. variation: h, one per
/// wire part.
std::vector<PlacedHelperWire> list_helper_wires(const Chart& prepared, std::size_t first_part,
                                                const Eigen::VectorXd& variation);

std::vector<HelperWire> place_helper_wires(std::vector<PlacedHelperWire> helpers, const Positions2& uv);

}  // namespace wirewarp
