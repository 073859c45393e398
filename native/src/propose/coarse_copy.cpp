// SPDX-License-Identifier: GPL-3.0-or-later
#include "propose/coarse_copy.h"

#include <cmath>
#include <utility>

#include "coarsen/coarse_chart.h"
#include "mesh/geometry.h"

namespace wirewarp {
namespace {

/// Asked for; about half as many come out. With half of these the order of the best cuts is no longer that of the piece
/// itself: on a hat the best dart of all was the eleventh.
constexpr double kFaces = 800;

}  // namespace

CoarseCopy coarse_copy(const Chart& chart, const StopToken& stop) {
  const double wanted = std::sqrt(4 / std::sqrt(3.0) * surface_area(chart.mesh) / kFaces);
  if (wanted < typical_edge_length(chart.mesh) || !can_coarsen(chart)) {
    return {chart, std::vector<VertexHandle>(chart.mesh.vertices_begin(), chart.mesh.vertices_end())};
  }
  CoarseChart coarse = coarsen(chart, build_held_network(chart), wanted, stop);
  CoarseCopy copy{std::move(coarse.chart), {}};
  copy.fine_vertex.resize(copy.chart.mesh.n_vertices());
  for (const VertexHandle v : chart.mesh.vertices()) {
    const CoarsePlace& place = coarse.places[v.idx()];
    if (place.weights[0] == 1) copy.fine_vertex[place.vertices[0]] = v;
  }
  return copy;
}

}  // namespace wirewarp
