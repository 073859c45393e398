// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/stop_token.h"
#include "surface/charts/chart.h"

namespace wirewarp {

/// The charts that some faces of an input make between these seams and their own outline, as cut_into_charts() has them
/// for the whole input: their sources are its vertices, faces and wires. Wire parts are numbered anew. faces: sorted.
/// Throws Stopped.
Charts cut_faces(const FlattenInput& input, const std::vector<int>& faces, const std::vector<VertexPair>& seams,
                 const StopToken& stop);

}  // namespace wirewarp
