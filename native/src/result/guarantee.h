// SPDX-License-Identifier: GPL-3.0-or-later
// Checks the guarantees about a flat piece: exact lengths, no flipped face, no overlap.
#pragma once

#include <optional>

#include "surface/network/wire_network.h"

namespace wirewarp {

/// Returns the error of the first guarantee that is broken, or nullopt if all guarantees hold:
///   lengths_not_kept   |l2 - (1+r)(1+h) l| > 1e-9 l + 8 machine epsilon max|uv| on a boundary, rigid or elastic edge,
///                      or |h - ease| > tolerance on an elastic part
///   flipped_faces      metrics.flipped_faces is not empty
///   overlapping_faces  metrics.overlapping_faces is not empty
/// l and l2 are the lengths of the edge on the surface and in the layout, and r is the ease of its side. The error's
/// sentence also mentions other broken guarantees, and its has_layout is true. uv, variation (h, one per wire part) and
/// metrics describe the final layout. wires: the input's wires, for their names. proposed_seams: seams that fix a
/// flipped or overlapping piece.
std::optional<FlattenError> check_guarantee(const Chart& chart, const WireNetwork& network,
                                            const std::vector<Wire>& wires, const Positions2& uv,
                                            const std::vector<double>& variation, const Metrics& metrics,
                                            const std::vector<VertexPair>& proposed_seams);

}  // namespace wirewarp
