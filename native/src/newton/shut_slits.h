// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "newton/refine_shape.h"

namespace wirewarp {

/// refine_shape() of a chart; slits that are shut at the start stay so, sewn: open rims that lie on one another are no
/// smooth point (newton/open_slits.h).
RefinedShape refine_with_shut_slits(const RefineTask& task, const RefinementStart& start,
                                    const RefinementLimits& limits);

}  // namespace wirewarp
