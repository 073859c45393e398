// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/network/wire_network.h"
#include "wirewarp/types.h"

namespace wirewarp {

/// Opens the triangles that a prolonged shape flips or nearly flips. A fine mesh has slivers that are folded over their
/// neighbors, and a smooth map keeps them so. Their vertices move to where the triangles around them fit best, their
/// neighbors after them as long as they move. Vertices of the network stay.
void unfold_slivers(const Chart& chart, const HeldNetwork& network, Positions2& uv);

}  // namespace wirewarp
