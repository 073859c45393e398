// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/network/wire_network.h"
#include "wirewarp/types.h"

namespace wirewarp {

/// Opens the triangles that a prolonged shape flips or nearly flips: fine meshes have slivers that are folded over
/// their neighbors, and a smooth map keeps them folded. Their vertices move to where the triangles around them fit
/// best, then the neighbors of all vertices that moved. Vertices of the network stay.
void unfold_slivers(const Chart& chart, const HeldNetwork& network, Positions2& uv);

}  // namespace wirewarp
