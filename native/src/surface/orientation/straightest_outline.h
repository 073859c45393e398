// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/charts/chart.h"

namespace wirewarp {

/// Returns the chord of the longest straight section of the outline in uv, with the piece on its left. Headings in a
/// section differ by at most 5 degrees. Of equally long sections, the first counts.
Eigen::Vector2d straightest_outline(const Chart& chart, const Positions2& uv);

}  // namespace wirewarp
