// SPDX-License-Identifier: GPL-3.0-or-later
#include "refine/coarse_start.h"

#include <algorithm>
#include <cmath>

#include "coarsen/prolong.h"
#include "mesh/geometry.h"
#include "refine/refine_chart.h"

namespace wirewarp {
namespace {

constexpr double kCoarsening = 4;       // length of a coarse edge over that of a fine one
constexpr double kLeastCoarsening = 2;  // a quarter of the faces: with more the coarse chart costs what it saves
constexpr double kPerWiggle = 0.9;      // length of a coarse edge over the shortest wiggle of wires, at most
constexpr int kMaxFactorizations = 30;  // and half of what is left: the chart itself needs some

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

std::optional<RefinementStart> start_from_coarse(const RefineTask& task, RefineBudget& budget, const StopToken& stop) {
  const Chart& chart = task.chart;
  const double fine = typical_edge_length(chart.mesh);
  const double wanted = std::min(kCoarsening * fine, kPerWiggle * task.fairness * std::sqrt(surface_area(chart.mesh)));
  if (wanted < kLeastCoarsening * fine || has_slit_of_one_edge(chart.mesh)) return std::nullopt;
  const StopToken at_start([at_start = stop.in("start")](const char*) { return at_start.may_go_on(); });
  at_start.check();
  const CoarseChart coarse = coarsen(chart, task.network, wanted, at_start);
  at_start.check();
  RefineBudget coarse_budget(budget, std::min(kMaxFactorizations, budget.left() / 2));
  const RefinedShape shape =
      refine_from_scratch({coarse.chart, coarse.network, task.fairness}, coarse_budget, at_start).shape;
  if (!shape.is_exact) return std::nullopt;
  at_start.check();
  return RefinementStart{prolong_positions(chart, task.network, coarse, shape.uv),
                         prolong_multipliers(coarse, shape.multipliers)};
}

}  // namespace wirewarp
