// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/shut_slits.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "newton/sewn_problem.h"

namespace wirewarp {
namespace {

// Rims of a slit that are nearer to one another than this share of the slit's length lie on one another: exact lengths
// leave a millionth of that.
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

RefinedShape refine_with_shut_slits(const RefineTask& task, const RefinementStart& start,
                                    const RefinementLimits& limits) {
  std::vector<Slit> slits = find_slits(task.chart);
  const auto is_open = [&](const Slit& slit) { return !is_shut(task.chart, slit, start.uv); };
  slits.erase(std::remove_if(slits.begin(), slits.end(), is_open), slits.end());
  std::optional<SewnChart> sewn;
  if (!slits.empty()) sewn = sew(task.chart, slits);
  if (!sewn) return refine_shape(task, start, limits);
  const SewnProblem problem(task, std::move(*sewn));
  return problem.as_open(task, refine_shape(problem.task(), problem.to_sewn(start), limits));
}

}  // namespace wirewarp
