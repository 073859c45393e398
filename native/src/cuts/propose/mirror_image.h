// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/stop_token.h"
#include "surface/charts/chart.h"
#include "warp/topology/surface_path.h"

namespace wirewarp {

/// Returns the mirror image of each vertex if a plane mirrors the chart onto itself, otherwise nothing. Of several
/// planes, it chooses the one with the longest edges in it, because cuts may follow them. Throws Stopped.
std::vector<VertexHandle> mirror_image(const Chart& chart, const StopToken& stop);

/// Returns the mirror image of a chain; empty if its edges are not mirrored with their vertices.
HalfEdgeChain mirrored(const Chart& chart, const std::vector<VertexHandle>& image, const HalfEdgeChain& chain);

/// Returns the mirror image of a path; empty if the edges and faces that it crosses are not mirrored with their
/// vertices.
MeshPath mirrored(const Chart& chart, const std::vector<VertexHandle>& image, const MeshPath& path);

}  // namespace wirewarp
