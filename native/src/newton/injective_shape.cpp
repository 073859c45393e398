// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/injective_shape.h"

#include <utility>

#include "base/attempt.h"
#include "newton/injective_start.h"
#include "newton/minimize.h"
#include "surface/charts/folded_faces.h"

namespace wirewarp {

Injectivity injectivity_of(const Chart& chart, const Positions2& uv) {
  if (has_flips(chart.mesh, uv)) return Injectivity::none;
  return has_overlaps(chart.mesh, uv) ? Injectivity::local : Injectivity::global;
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
