// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/network/wire_network.h"
#include "wirewarp/types.h"

namespace wirewarp {

/// Unfolds triangles that are flipped or nearly flipped in a prolonged shape: fine meshes have slivers that are folded
/// over their neighbors, and a smooth map keeps these folds. The vertices of slivers move to where the triangles around
/// them fit best, then the neighbors of all vertices that moved. Vertices of the network stay.
void unfold_slivers(const Chart& chart, const HeldNetwork& network, Positions2& uv);

}  // namespace wirewarp
