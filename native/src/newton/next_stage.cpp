// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/next_stage.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "base/attempt.h"
#include "newton/injective_start.h"
#include "newton/minimize.h"
#include "newton/sewn_problem.h"

namespace wirewarp {
namespace {

// Largest gap between the rims of a shut slit, divided by the length of the slit. With exact lengths, it is 1e-13.
constexpr double kShut = 1e-7;

bool is_shut(const Chart& chart, const Slit& slit, const Positions2& uv) {
  const auto place = [&](VertexHandle v) { return uv.row(v.idx()); };
  double length = 0, gap = 0;
  for (std::size_t i = 0; i < slit.rims.size(); ++i) {
    const HalfedgeHandle rim = slit.rims[i], mate = slit.rims[slit.mate[i]];
    const auto begin = place(chart.mesh.from_vertex_handle(rim)), end = place(chart.mesh.to_vertex_handle(rim));
    length += (end - begin).norm();
    gap = std::max(gap, (place(chart.mesh.to_vertex_handle(mate)) - begin).norm());
  }
  return gap < kShut * length;
}

}  // namespace

Solution minimize_next(Problem& problem, const Stage& stage, const Shape& start, const Control& control) {
  std::vector<Slit> shut;
  for (const Slit& slit : problem.slits()) {
    if (is_shut(problem.chart(), slit, start.uv)) shut.push_back(slit);
  }
  const std::unique_ptr<SewnProblem> sewn = shut.empty() ? nullptr : sew_slits(problem, stage, shut);
  Solution found = sewn ? sewn->minimize(start, control) : minimize(problem, stage, start, control);
  const bool may_not_flip = stage.injectivity != Injectivity::none;
  if (!found.is_exact() && may_not_flip && problem.objective({stage.cloth}).count_flips(start.uv) == 0) {
    const std::optional<Shape> exact = attempt([&] { return injective_start(problem, stage, control, start.uv); });
    if (exact) found = minimize(problem, stage, *exact, control);
  }
  return found;
}

}  // namespace wirewarp
