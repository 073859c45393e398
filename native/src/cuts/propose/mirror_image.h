// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/stop_token.h"
#include "surface/charts/chart.h"
#include "warp/topology/surface_path.h"

namespace wirewarp {

/// Returns the mirror image of each vertex if a plane mirrors the chart onto itself; otherwise empty. Of several
/// planes, uses the plane that contains the greatest length of edges, because cuts may follow them. Throws Stopped.
std::vector<VertexHandle> mirror_image(const Chart& chart, const StopToken& stop);

/// Returns the mirror image of each vertex; empty if the plane does not mirror the chart. The plane has this normal and
/// contains the mean of all vertices.
std::vector<VertexHandle> mirror_image(const Chart& chart, const Eigen::RowVector3d& normal);

/// Returns the mirror image of a chain; empty if an edge of the chain has no mirror image inside the chart.
HalfEdgeChain mirrored(const Chart& chart, const std::vector<VertexHandle>& image, const HalfEdgeChain& chain);

/// Returns the mirror image of a path; empty if an edge or face that the path crosses has no mirror image.
MeshPath mirrored(const Chart& chart, const std::vector<VertexHandle>& image, const MeshPath& path);

}  // namespace wirewarp
