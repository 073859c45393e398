// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/stop_token.h"
#include "surface/mesh/half_edge_mesh.h"
#include "wirewarp/types.h"

namespace wirewarp {

// In all functions, uv has at least one row per vertex.

bool has_flips(const HalfEdgeMesh& mesh, const Positions2& uv);

bool has_overlaps(const HalfEdgeMesh& mesh, const Positions2& uv);

inline bool has_folds(const HalfEdgeMesh& mesh, const Positions2& uv) {
  return has_flips(mesh, uv) || has_overlaps(mesh, uv);
}

/// Returns the faces of a flat piece that are flipped or overlap other faces, in increasing order. Throws Stopped.
std::vector<int> find_folded_faces(const HalfEdgeMesh& mesh, const Positions2& uv, const StopToken& stop);

}  // namespace wirewarp
