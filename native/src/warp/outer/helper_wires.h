// SPDX-License-Identifier: GPL-3.0-or-later
// The wires that topology processing added (paper III), for the report.
#pragma once

#include <vector>

#include "surface/charts/chart.h"

namespace wirewarp {

/// A helper wire and where its points lie among the rows of a layout.
struct PlacedHelperWire {
  HelperWire wire;            // points_2d still empty
  std::vector<int> vertices;  // of the prepared chart
};

/// The wire parts of a prepared chart from first_part on. variation: h, one per wire part.
std::vector<PlacedHelperWire> list_helper_wires(const Chart& prepared, std::size_t first_part,
                                                const Eigen::VectorXd& variation);

/// The helper wires with their points in the finished layout.
std::vector<HelperWire> place_helper_wires(std::vector<PlacedHelperWire> helpers, const Positions2& uv);

}  // namespace wirewarp
