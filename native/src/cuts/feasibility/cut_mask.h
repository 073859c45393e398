// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "surface/mesh/half_edge_mesh.h"
#include "surface/mesh/shortest_paths.h"
#include "wirewarp/types.h"

namespace wirewarp {

/// Edges to cut along, one flag per edge of a chart's mesh.
using CutMask = std::vector<char>;

CutMask cut_along(const HalfEdgeMesh& mesh, const std::vector<HalfedgeHandle>& half_edges);

bool is_empty(const CutMask& cut);

/// Adds the edges of another cut.
void unite(CutMask& cut, const CutMask& other);

/// Length of all cut edges, scene units.
double length_of_cut(const HalfEdgeMesh& mesh, const CutMask& cut);

/// (k, 2) pairs as a list.
std::vector<VertexPair> as_list(const VertexPairs& pairs);
VertexPairs as_pairs(const std::vector<VertexPair>& list);

/// Paths along no edge of this mask, which is kept by reference.
PathRules around(const HalfEdgeMesh& mesh, const CutMask& forbidden);

}  // namespace wirewarp
