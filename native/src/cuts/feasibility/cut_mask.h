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

/// Adds the edges of the cut `other` to the cut `cut`.
void unite(CutMask& cut, const CutMask& other);

/// Returns the input vertices at the ends of each cut edge, in the order of the mesh's edges.
std::vector<VertexPair> edges_of(const Chart& chart, const CutMask& cut);

/// Returns the input vertices at the ends of each outline edge, sorted.
std::vector<VertexPair> outline_of(const Chart& chart);

/// Returns the length of all cut edges in scene units.
double length_of_cut(const HalfEdgeMesh& mesh, const CutMask& cut);

/// Returns rules for paths that avoid forbidden edges. The rules keep references to the mesh and the mask.
PathRules around(const HalfEdgeMesh& mesh, const CutMask& forbidden);

}  // namespace wirewarp
