// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/injective_shape.h"

#include <utility>

#include "base/attempt.h"
#include "base/planar.h"
#include "energy/tutte_embedding.h"
#include "newton/injective_start.h"
#include "surface/mesh/geometry.h"
#include "surface/mesh/overlap.h"

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

std::optional<RefinementStart> reach_injectively(StartProblem& problem, Injectivity injectivity) {
  if (!problem.budget.allows()) return std::nullopt;
  const Chart& chart = problem.task.chart;
  Positions2 map = problem.free_map();
  if (injectivity_of(chart, map) < injectivity) map = tutte_embedding(chart, problem.stop.in("start"));
  if (injectivity_of(chart, map) < injectivity) return std::nullopt;  // rounding spoils the embedding
  return injective_start(problem.task, map, {problem.budget, problem.stop.in("shape"), injectivity});
}

namespace {

/// The least distorted shape with exact lengths and the given injectivity. Not exact if it is not found.
RefinedShape refine_injectively(StartProblem& problem, Injectivity injectivity) {
  const auto start = attempt([&] { return reach_injectively(problem, injectivity); });
  if (!start) return {};
  return refine_shape(problem.task, *start, {problem.budget, problem.stop.in("shape"), injectivity});
}

}  // namespace

bool make_injective(StartProblem& problem, RefinedShape& shape) {
  if (!shape.is_exact() || !problem.stop.in("shape").may_go_on()) return false;
  const Chart& chart = problem.task.chart;
  bool is_other = false;
  shape.injectivity = injectivity_of(chart, shape.uv);
  for (const Injectivity injectivity : {Injectivity::local, Injectivity::global}) {
    const bool is_disk = chart.boundary_loops.size() == 1;  // a ring that overlaps had best be cut open
    if (injectivity == Injectivity::global && !is_disk) continue;
    if (problem.stop.is_stopped() || shape.injectivity >= injectivity) continue;
    RefinedShape injective = refine_injectively(problem, injectivity);
    if (!injective.is_exact()) continue;
    shape = std::move(injective);
    is_other = true;
    shape.injectivity = injectivity_of(chart, shape.uv);
  }
  return is_other;
}

}  // namespace wirewarp
