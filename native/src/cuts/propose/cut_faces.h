// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/stop_token.h"
#include "surface/charts/chart.h"

namespace wirewarp {

/// Cuts some faces out of an input, and divides them along seams. The result equals that of cut_into_charts(), except
/// that the parts of a wire have other numbers, and `is_boundary_wire` is not set. Throws Stopped.
/// - fans: fans_of_uncut_surface() of the whole input
/// - faces: the faces to cut out, sorted
Charts cut_faces(const FlattenInput& input, const std::vector<int>& fans, const std::vector<int>& faces,
                 const std::vector<VertexPair>& seams, const StopToken& stop);

}  // namespace wirewarp
