// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/injective_shape.h"

#include <utility>

#include "base/attempt.h"
#include "base/planar.h"
#include "newton/injective_start.h"
#include "newton/minimize.h"
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

void make_injective(Problem& problem, Stage stage, const Control& control, Solution& solution) {
  if (!solution.is_exact() || !control.stop.in("shape").may_go_on()) return;
  const Chart& chart = problem.chart();
  solution.injectivity = injectivity_of(chart, solution.shape.uv);
  for (const Injectivity injectivity : {Injectivity::local, Injectivity::global}) {
    const bool is_disk = chart.boundary_loops.size() == 1;  // a ring that overlaps itself is better cut open
    if (injectivity == Injectivity::global && !is_disk) continue;
    if (control.stop.is_stopped() || solution.injectivity >= injectivity) continue;
    stage.injectivity = injectivity;
    const auto start = attempt([&] { return injective_start(problem, stage, control); });
    if (!start) continue;
    Solution injective = minimize(problem, stage, *start, control.in("shape"));
    if (!injective.is_exact()) continue;
    solution = std::move(injective);
    solution.start = kInjectiveStart;
    solution.injectivity = injectivity_of(chart, solution.shape.uv);
  }
}

}  // namespace wirewarp
