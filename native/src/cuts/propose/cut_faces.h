// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/stop_token.h"
#include "surface/charts/chart.h"

namespace wirewarp {

/// Cuts some faces of an input along seams and along the outline of these faces. The result is as from
/// cut_into_charts(), but the parts of a wire have other numbers, and `is_boundary_wire` is not set. Throws Stopped.
/// - faces: sorted
Charts cut_faces(const FlattenInput& input, const std::vector<int>& faces, const std::vector<VertexPair>& seams,
                 const StopToken& stop);

}  // namespace wirewarp
