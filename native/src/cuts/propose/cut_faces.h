// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/stop_token.h"
#include "surface/charts/chart.h"

namespace wirewarp {

/// Cuts some faces of an input along seams and along the outline of these faces, as cut_into_charts() does for the
/// whole input. The sources of the charts are the input's vertices, faces and wires. The numbers of wire parts differ
/// from the numbers that cut_into_charts() uses. faces: sorted. Throws Stopped.
Charts cut_faces(const FlattenInput& input, const std::vector<int>& faces, const std::vector<VertexPair>& seams,
                 const StopToken& stop);

}  // namespace wirewarp
