// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/charts/chart.h"

namespace wirewarp {

/// Returns the area that the boundary loops enclose in the layout uv, without holes, in scene units squared; negative
/// in a mirror image.
double enclosed_area(const Chart& chart, const Positions2& uv);

}  // namespace wirewarp
