// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/charts/chart.h"

namespace wirewarp {

/// What the boundary loops enclose in the layout uv, holes taken off; negative in a mirror image. Scene units squared.
double enclosed_area(const Chart& chart, const Positions2& uv);

}  // namespace wirewarp
