// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/stop_token.h"
#include "surface/charts/chart.h"
#include "warp/topology/surface_path.h"

namespace wirewarp {

/// The mirror image of each vertex of a chart that a plane mirrors onto itself; no entries if no plane does. Of several
/// planes it is the one along which edges run longest: cuts may follow it. Throws Stopped.
std::vector<VertexHandle> mirror_image(const Chart& chart, const StopToken& stop);

/// A chain's mirror image. Empty where the edges are not mirrored with their vertices.
HalfEdgeChain mirrored(const Chart& chart, const std::vector<VertexHandle>& image, const HalfEdgeChain& chain);

/// A path's mirror image. Empty if the edges and faces that it crosses are not mirrored with their vertices.
MeshPath mirrored(const Chart& chart, const std::vector<VertexHandle>& image, const MeshPath& path);

}  // namespace wirewarp
