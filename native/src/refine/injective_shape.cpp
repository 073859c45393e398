// SPDX-License-Identifier: GPL-3.0-or-later
#include "refine/injective_shape.h"

#include <utility>

#include "arap/free_boundary_arap.h"
#include "arap/tutte_embedding.h"
#include "factorization_failed.h"
#include "mesh/geometry.h"
#include "mesh/overlap.h"
#include "planar.h"
#include "refine/injective_start.h"

namespace wirewarp {
namespace {

bool has_flips(const Triangles& triangles, const Positions2& uv) {
  for (const auto& t : triangles.rowwise()) {
    const Eigen::Vector2d a = uv.row(t[0]), b = uv.row(t[1]), c = uv.row(t[2]);
    if (!(cross(b - a, c - a) > 0)) return true;
  }
  return false;
}

}  // namespace

Injectivity injectivity_of(const Chart& chart, const Positions2& uv) {
  const Triangles triangles = triangles_of(chart.mesh);
  if (has_flips(triangles, uv)) return Injectivity::none;
  const bool overlaps = !find_overlapping_faces(triangles, faces_on_boundary(chart.mesh), uv).empty();
  return overlaps ? Injectivity::local : Injectivity::global;
}

std::optional<RefinementStart> reach_injectively(const RefineTask& task, const RefinementLimits& limits) {
  if (!limits.budget.allows()) return std::nullopt;
  Positions2 map = free_boundary_arap(task.chart, kFreeSteps, {}, limits.stop.in("start")).uv;
  if (injectivity_of(task.chart, map) < limits.injectivity) map = tutte_embedding(task.chart, limits.stop.in("start"));
  if (injectivity_of(task.chart, map) < limits.injectivity) return std::nullopt;  // rounding spoils the embedding
  RefinementLimits in_shape = limits;
  in_shape.stop = limits.stop.in("shape");
  return injective_start(task, map, in_shape);
}

namespace {

/// The least distorted shape with exact lengths and the injectivity of the limits. Not exact where it is not found.
RefinedShape refine_injectively(const RefineTask& task, const RefinementLimits& limits) {
  const std::optional<RefinementStart> start = reach_injectively(task, limits);
  if (!start) return {};
  RefinementLimits in_shape = limits;
  in_shape.stop = limits.stop.in("shape");
  return refine_shape(task, *start, in_shape);
}

}  // namespace

bool make_injective(const RefineTask& task, const RefinementLimits& limits, RefinedShape& shape) {
  if (!shape.is_exact || !limits.stop.in("shape").may_go_on()) return false;
  bool is_other = false;
  shape.injectivity = injectivity_of(task.chart, shape.uv);
  for (const Injectivity injectivity : {Injectivity::local, Injectivity::global}) {
    const bool is_disk = task.chart.boundary_loops.size() == 1;  // a ring that overlaps had best be cut open
    if (injectivity == Injectivity::global && !is_disk) continue;
    if (limits.stop.is_stopped() || shape.injectivity >= injectivity) continue;
    try {
      RefinedShape injective = refine_injectively(task, {limits.budget, limits.stop, injectivity});
      if (!injective.is_exact) continue;
      shape = std::move(injective);
      is_other = true;
      shape.injectivity = injectivity_of(task.chart, shape.uv);
    } catch (const Stopped&) {  // the shape at hand has exact lengths
      break;
    } catch (const FactorizationFailed&) {
      break;
    }
  }
  return is_other;
}

}  // namespace wirewarp
