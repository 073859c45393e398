// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/stop_token.h"
#include "surface/charts/chart.h"
#include "warp/topology/surface_path.h"

namespace wirewarp {

/// Returns the mirror image of each vertex if a plane mirrors the chart onto itself; otherwise empty. If there are
/// several planes, chooses the plane that contains the longest edges, because cuts may follow these. Throws Stopped.
std::vector<VertexHandle> mirror_image(const Chart& chart, const StopToken& stop);

/// Returns the mirror image of each vertex by the plane with this normal; empty if it does not mirror the chart.
std::vector<VertexHandle> mirror_image(const Chart& chart, const Eigen::RowVector3d& normal);

/// Returns the mirror image of a chain; empty if its edges are not mirrored with their vertices.
HalfEdgeChain mirrored(const Chart& chart, const std::vector<VertexHandle>& image, const HalfEdgeChain& chain);

/// Returns the mirror image of a path; empty if the edges and faces that it crosses are not mirrored with their
/// vertices.
MeshPath mirrored(const Chart& chart, const std::vector<VertexHandle>& image, const MeshPath& path);

}  // namespace wirewarp
