// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/charts/isoperimetric.h"

#include <algorithm>
#include <cmath>

#include "base/planar.h"
#include "surface/mesh/geometry.h"

namespace wirewarp {
namespace {

/// Minimum p of a chart with one loop (see isoperimetric_ratio()). For three quarters of a sphere, p is 1/4: all
/// lengths would shrink to half on average, which no fabric allows. Hemispheres (1/2) and padded cushions (0.4) are
/// still useful.
constexpr double kRequiredOfDisk = 0.25;

/// Minimum p of a chart with several loops. It accepts a hemisphere with an eyelet (1/2), but not tubes. In garments, p
/// is 0.33 to 0.39 for sleeves and open upper bodies, 0.07 to 0.16 for legs and whole shirts, and at least 0.6 for cut
/// panels.
constexpr double kRequiredOfTube = 0.45;

}  // namespace

std::vector<double> longest_lengths(const Chart& chart) {
  std::vector<double> stretch(chart.mesh.n_edges(), 1);
  for (const WirePart& part : chart.wire_parts) {
    if (!is_elastic_boundary(part)) continue;
    for (const HalfedgeHandle h : part.half_edges) stretch[chart.mesh.edge_handle(h).idx()] += solver_tolerance(part);
  }
  std::vector<double> lengths;
  for (const HalfEdgeChain& loop : chart.boundary_loops) {
    double& length = lengths.emplace_back(0);
    for (const HalfedgeHandle h : loop) {
      length += stretch[chart.mesh.edge_handle(h).idx()] * length_ratio(chart, h) * edge_length(chart.mesh, h);
    }
  }
  return lengths;
}

double isoperimetric_ratio(const Chart& chart) {
  double longest = 0;
  for (const double length : longest_lengths(chart)) longest = std::max(longest, length);
  return longest * longest / (4 * kPi * surface_area(chart.mesh));
}

double least_shape_error(double share) {
  if (share >= 1) return 0;
  const double missing = 1 - std::sqrt(share);
  return share <= 0.25 ? 1 - 2 * share : 2 * missing * missing;
}

bool is_outline_too_short(const Chart& chart) {
  return isoperimetric_ratio(chart) < (chart.boundary_loops.size() > 1 ? kRequiredOfTube : kRequiredOfDisk);
}

}  // namespace wirewarp
