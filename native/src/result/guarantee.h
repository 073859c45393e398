// SPDX-License-Identifier: GPL-3.0-or-later
// Checks the guarantees about a flat piece: exact lengths, no flipped face, no overlap.
#pragma once

#include <optional>

#include "surface/network/wire_network.h"

namespace wirewarp {

/// Returns the error of the first guarantee that is broken, or nullopt if all guarantees hold.
///
/// - l, l2: length of an edge on the surface and in the layout
/// - h: entry of `variation` for the wire part of the edge
/// - r: ease of the edge's side
///
/// The errors, with has_layout true, are:
///
/// - lengths_not_kept: |l2 - (1+r)(1+h) l| > 1e-9 l + 8 machine epsilon max|uv| on a boundary, rigid or elastic edge
/// - lengths_not_kept: |h - ease| > tolerance on an elastic part
/// - flipped_faces: metrics.flipped_faces is not empty
/// - overlapping_faces: metrics.overlapping_faces is not empty
///
/// proposed_seams: seams that fix a flipped or overlapping piece.
std::optional<FlattenError> check_guarantee(const Chart& chart, const WireNetwork& network,
                                            const std::vector<Wire>& wires, const Positions2& uv,
                                            const std::vector<double>& variation, const Metrics& metrics,
                                            const std::vector<VertexPair>& proposed_seams);

}  // namespace wirewarp
