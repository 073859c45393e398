// SPDX-License-Identifier: GPL-3.0-or-later
#include "cuts/propose/coarse_copy.h"

#include <cmath>
#include <utility>

#include "newton/coarsen/coarse_chart.h"
#include "surface/mesh/geometry.h"

namespace wirewarp {

CoarseCopy coarse_copy(const Chart& chart, double faces, const StopToken& stop) {
  const double wanted = std::sqrt(4 / std::sqrt(3.0) * surface_area(chart.mesh) / faces);
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
