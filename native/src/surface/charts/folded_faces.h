// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "surface/mesh/half_edge_mesh.h"
#include "wirewarp/types.h"

namespace wirewarp {

/// Returns the faces of a flat piece that are flipped or overlap others, in increasing order. uv: at least one row per
/// vertex.
std::vector<int> find_folded_faces(const HalfEdgeMesh& mesh, const Positions2& uv);

}  // namespace wirewarp
