// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/charts/chart.h"

namespace wirewarp {

/// Along the longest straight stretch of the outline in the layout uv, the piece on its left: the longest run of edges
/// whose headings stay within 5 degrees of one another. Of stretches as long as one another the first along the loop.
/// Not normalized.
Eigen::Vector2d straightest_outline(const Chart& chart, const Positions2& uv);

}  // namespace wirewarp
