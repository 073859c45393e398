// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "surface/charts/chart.h"
#include "surface/mesh/shortest_paths.h"
#include "wirewarp/types.h"

namespace wirewarp {

/// Edges to cut along, one flag per edge of a chart's mesh.
using CutMask = std::vector<char>;

CutMask cut_along(const HalfEdgeMesh& mesh, const std::vector<HalfedgeHandle>& half_edges);

bool is_empty(const CutMask& cut);

/// Adds the edges of another cut.
void unite(CutMask& cut, const CutMask& other);

/// Returns the ends of the cut edges in the input, in the order of the mesh.
std::vector<VertexPair> edges_of(const Chart& chart, const CutMask& cut);

/// Returns the ends of the outline's edges in the input, sorted.
std::vector<VertexPair> outline_of(const Chart& chart);

/// Returns the length of all cut edges in scene units.
double length_of_cut(const HalfEdgeMesh& mesh, const CutMask& cut);

/// Rules for paths that avoid the edges of this mask; the mask is kept by reference.
PathRules around(const HalfEdgeMesh& mesh, const CutMask& forbidden);

}  // namespace wirewarp
