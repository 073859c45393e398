// SPDX-License-Identifier: GPL-3.0-or-later
#include "refine/injective_shape.h"

#include <algorithm>
#include <utility>

#include "arap/free_boundary_arap.h"
#include "arap/tutte_embedding.h"
#include "mesh/geometry.h"
#include "mesh/overlap.h"
#include "refine/injective_start.h"

namespace wirewarp {
namespace {

bool has_flips(const Chart& chart, const Positions2& uv) {
  const ShapeError shape_error(chart);
  return std::any_of(shape_error.triangles().begin(), shape_error.triangles().end(),
                     [&](const ShapeError::Triangle& t) { return !(ShapeError::map_of(t, uv).determinant() > 0); });
}

}  // namespace

Injectivity injectivity_of(const Chart& chart, const Positions2& uv) {
  if (has_flips(chart, uv)) return Injectivity::none;
  const bool overlaps = !find_overlapping_faces(triangles_of(chart.mesh), faces_on_boundary(chart.mesh), uv).empty();
  return overlaps ? Injectivity::local : Injectivity::global;
}

RefinedShape refine_injectively(const Chart& chart, const WireNetwork& network, Injectivity injectivity,
                                RefineBudget& budget) {
  Positions2 map = free_boundary_arap(chart, kFreeSteps, {}, budget.asking("start")).uv;
  if (injectivity_of(chart, map) < injectivity) map = tutte_embedding(chart);
  if (budget.was_stopped() || injectivity_of(chart, map) < injectivity) return {};  // rounding spoils the embedding
  const InjectiveStart reached =
      injective_start(chart, network, budget.fairness(), map, budget.limits(kNoLimit, injectivity));
  budget.count(reached.factorizations);
  if (!reached.start || budget.was_stopped()) return {};
  RefinedShape shape = budget.refine(chart, network, *reached.start, kNoLimit, injectivity);
  // Parts of the outline that came near each other on the way are not in the Hessian yet.
  while (injectivity == Injectivity::global && shape.is_exact && !shape.converged && !budget.ran_out()) {
    RefinedShape next = budget.refine(chart, network, {shape.uv, shape.multipliers}, kNoLimit, injectivity);
    if (!(next.objective < shape.objective)) break;
    shape = std::move(next);
  }
  return shape;
}

RefinedShape make_injective(const Chart& chart, const WireNetwork& network, RefinedShape shape, RefineBudget& budget) {
  for (const Injectivity injectivity : {Injectivity::local, Injectivity::global}) {
    const bool is_disk = chart.boundary_loops.size() == 1;  // a ring that overlaps had best be cut open
    if (injectivity == Injectivity::global && !is_disk) continue;
    if (budget.ran_out() || !shape.is_exact || injectivity_of(chart, shape.uv) >= injectivity) continue;
    RefinedShape injective = refine_injectively(chart, network, injectivity, budget);
    if (injective.is_exact) shape = std::move(injective);
  }
  return shape;
}

}  // namespace wirewarp
