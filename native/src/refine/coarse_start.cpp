// SPDX-License-Identifier: GPL-3.0-or-later
#include "refine/coarse_start.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "coarsen/prolong.h"
#include "mesh/geometry.h"
#include "refine/refine_chart.h"

namespace wirewarp {
namespace {

constexpr double kCoarsening = 4;  // length of a coarse edge over that of a fine one
constexpr double kLeastCoarsening = 2;
constexpr double kPerWiggle = 0.3;  // length of a coarse edge over the shortest wiggle of wires, at most
constexpr int kMaxFactorizations = 30;

/// Of the edges of as many equilateral triangles with the same area, scene units.
double typical_edge_length(const HalfEdgeMesh& mesh) {
  return std::sqrt(4 / std::sqrt(3.0) * surface_area(mesh) / static_cast<double>(mesh.n_faces()));
}

/// A slit of one edge has two sides between the same two vertices; coarsening knows an edge by its ends.
bool has_slit_of_one_edge(const HalfEdgeMesh& mesh) {
  return std::any_of(mesh.halfedges_begin(), mesh.halfedges_end(), [&](const HalfedgeHandle h) {
    return mesh.is_boundary(h) && mesh.next_halfedge_handle(mesh.next_halfedge_handle(h)) == h;
  });
}

}  // namespace

std::optional<RefinementStart> start_from_coarse(const Chart& chart, const WireNetwork& network, const Options& options,
                                                 const std::function<bool()>& go_on) {
  const double fine = typical_edge_length(chart.mesh);
  const double wanted =
      std::min(kCoarsening * fine, kPerWiggle * options.fairness * std::sqrt(surface_area(chart.mesh)));
  if (wanted < kLeastCoarsening * fine || has_slit_of_one_edge(chart.mesh) || !go_on()) return std::nullopt;
  const CoarseChart coarse = coarsen(chart, network, wanted, go_on);
  if (!go_on()) return std::nullopt;
  Options brief = options;
  brief.max_factorizations = std::min(options.max_factorizations, kMaxFactorizations);
  try {
    const RefinedShape shape =
        refine_from_scratch(coarse.chart, coarse.network, brief, [&](const char*) { return go_on(); }).shape;
    if (!shape.is_exact || !go_on()) return std::nullopt;
    return RefinementStart{prolong_positions(chart, network, coarse, shape.uv),
                           prolong_multipliers(coarse, shape.multipliers)};
  } catch (const std::domain_error&) {  // a factorization broke down, or no topology serves the coarse wires
    return std::nullopt;
  }
}

}  // namespace wirewarp
