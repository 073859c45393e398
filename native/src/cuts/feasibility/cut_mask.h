// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "surface/charts/chart.h"
#include "surface/mesh/shortest_paths.h"
#include "wirewarp/types.h"

namespace wirewarp {

/// For each edge of a chart's mesh: 1 if the cut follows the edge, otherwise 0.
using CutMask = std::vector<char>;

CutMask cut_along(const HalfEdgeMesh& mesh, const std::vector<HalfedgeHandle>& half_edges);

bool is_empty(const CutMask& cut);

void unite(CutMask& cut, const CutMask& other);

/// Returns the input vertices at the ends of each cut edge, in the order of the mesh's edges.
std::vector<VertexPair> edges_of(const Chart& chart, const CutMask& cut);

/// Returns the input vertices at the ends of each outline edge, sorted.
std::vector<VertexPair> outline_of(const Chart& chart);

/// Returns the length of all cut edges in scene units.
double length_of_cut(const HalfEdgeMesh& mesh, const CutMask& cut);

/// Returns rules for paths that avoid forbidden edges. The mesh and the mask must outlive the rules.
PathRules around(const HalfEdgeMesh& mesh, const CutMask& forbidden);

}  // namespace wirewarp
