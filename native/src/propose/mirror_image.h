// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "charts/chart.h"

namespace wirewarp {

/// For each vertex of a chart that a plane mirrors onto itself the vertex opposite; none where no plane does. Of
/// several planes it is the one along which edges run longest: cuts may follow it. Throws Stopped where go_on says no.
std::vector<VertexHandle> mirror_image(const Chart& chart, const std::function<bool()>& go_on);

/// A chain's mirror image. Empty where the edges are not mirrored with their vertices.
HalfEdgeChain mirrored(const Chart& chart, const std::vector<VertexHandle>& image, const HalfEdgeChain& chain);

}  // namespace wirewarp
