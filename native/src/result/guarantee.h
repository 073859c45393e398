// SPDX-License-Identifier: GPL-3.0-or-later
// All guarantees about a flat piece, checked: exact lengths, no flipped face, no overlap with itself.
#pragma once

#include <optional>

#include "surface/network/wire_network.h"

namespace wirewarp {

/// The first guarantee that does not hold, or nothing if all do:
///   lengths_not_kept   |l2 - (1+r)(1+h) l| > 1e-9 l + 8 machine epsilon max|uv| on a boundary, rigid or elastic edge,
///                      r the ease of its side, or |h - ease| > tolerance on an elastic part
///   flipped_faces      metrics.flipped_faces is not empty
///   overlapping_faces  metrics.overlapping_faces is not empty
/// The message mentions the others too; has_layout is true. uv, variation (h per wire part) and metrics
/// belong to the layout as it is handed to the user. wires: the input's, for the names. proposed_seams: what the error
/// of a flipped or overlapping piece proposes.
std::optional<FlattenError> check_guarantee(const Chart& chart, const WireNetwork& network,
                                            const std::vector<Wire>& wires, const Positions2& uv,
                                            const std::vector<double>& variation, const Metrics& metrics,
                                            const std::vector<VertexPair>& proposed_seams);

}  // namespace wirewarp
