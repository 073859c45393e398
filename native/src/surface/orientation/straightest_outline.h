// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/charts/chart.h"

namespace wirewarp {

/// Returns the direction of the longest straight section of the outline in the layout uv, with the piece on its left:
/// the longest run of edges whose headings differ by at most 5 degrees. If several runs are equally long, uses the
/// first along the loop. The direction is not normalized.
Eigen::Vector2d straightest_outline(const Chart& chart, const Positions2& uv);

}  // namespace wirewarp
