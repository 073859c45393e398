// SPDX-License-Identifier: GPL-3.0-or-later
#include "join_charts.h"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "charts/seams_that_give.h"
#include "factorization_failed.h"
#include "feasibility/folded_faces.h"
#include "network/length_variation.h"
#include "piece_report.h"
#include "progress_report.h"
#include "refine/refine_chart.h"
#include "refine/refine_cloth.h"
#include "refine/refine_together.h"

namespace wirewarp {
namespace {

std::vector<char> find_folded(const std::vector<ChartToJoin>& charts) {
  std::vector<char> is_folded;
  for (const ChartToJoin& one : charts) {
    is_folded.push_back(find_folded_faces(one.chart.mesh, one.solved.uv).empty() ? 0 : 1);
  }
  return is_folded;
}

/// None where no common lengths are found.
std::optional<JoinedShapes> find_shapes(const std::vector<ChartToJoin>& charts, const InternalOptions& options,
                                        RefineBudget& budget, const StopToken& stop) {
  std::vector<Chart> copies;
  std::vector<ClothOnChart> cloths;
  std::vector<RefinementStart> starts;
  for (const ChartToJoin& one : charts) {
    copies.push_back(one.chart);
    starts.emplace_back(one.solved.uv, one.solved.multipliers);
    if (one.cloth) cloths.push_back(*one.cloth);
  }
  try {
    const Injectivity injectivity = options.cloth ? Injectivity::local : Injectivity::none;
    JoinedShapes joined =
        refine_together(copies, options.fairness, cloths, starts, {budget, stop.in("shape"), injectivity});
    return joined.shapes.front().is_exact ? std::optional(std::move(joined)) : std::nullopt;
  } catch (const FactorizationFailed&) {
    return std::nullopt;
  } catch (const Stopped&) {
    return std::nullopt;
  }
}

/// The chart alone with its seams at these lengths, if that shape is good. Whether it is.
bool replace_folded(const std::vector<ChartToJoin>& charts, std::size_t index, const RefineAlone& refine_alone,
                    const StopToken& stop) {
  if (stop.is_stopped()) return false;
  SolvedChart& solved = charts[index].solved;
  const Chart settled = with_settled_seams(charts[index].chart, solved.variation);
  std::optional<RefineResult> refined = refine_alone(index, settled, stop);
  if (!refined) return false;
  refined->factorizations += solved.report.factorizations;
  solved.report.warnings.clear();
  report_refinement(*refined, stop.is_stopped(), solved.report);
  solved.report.projected_gradient = std::numeric_limits<double>::quiet_NaN();
  solved.variation = variations_of(settled, refined->shape.variation);
  solved.uv = std::move(refined->shape.uv);
  return true;
}

void take_shape(RefinedShape shape, double projected_gradient, bool was_stopped, const ChartToJoin& one) {
  SolvedChart& solved = one.solved;
  report_next_refinement(shape, was_stopped, solved.report);
  solved.report.projected_gradient = projected_gradient;
  solved.variation = variations_of(one.chart, shape.variation);
  solved.uv = std::move(shape.uv);
}

/// All at h = ease, and none turned over or over itself.
bool were_good(const std::vector<ChartToJoin>& charts, const std::vector<SolvedChart>& before) {
  for (std::size_t k = 0; k < charts.size(); ++k) {
    if (!charts[k].is_settled || !find_folded_faces(charts[k].chart.mesh, before[k].uv).empty()) return false;
  }
  return true;
}

}  // namespace

std::optional<RefineResult> refine_unfolded(const Chart& chart, const InternalOptions& options, const StopToken& stop) {
  try {
    RefineResult refined = refine_chart(chart, options, stop);
    const bool is_good = refined.shape.is_exact && refined.shape.injectivity == Injectivity::global;
    if (is_good && options.cloth) refine_cloth(chart, options, stop.in("shape"), refined);
    return is_good ? std::optional(std::move(refined)) : std::nullopt;
  } catch (const FactorizationFailed&) {
    return std::nullopt;
  } catch (const Stopped&) {
    return std::nullopt;
  }
}

JoinOutcome join_charts(const std::vector<ChartToJoin>& charts, const InternalOptions& options,
                        const RefineAlone& refine_alone, const StopToken& stop) {
  std::vector<SolvedChart> before;
  for (const ChartToJoin& one : charts) before.push_back(one.solved);
  RefineBudget budget(options.max_factorizations);
  std::optional<JoinedShapes> joined;
  std::map<std::string, double> seconds;
  {
    const StageTimer timer(seconds, "shape");
    joined = find_shapes(charts, options, budget, stop);
  }
  charts.front().solved.report.seconds["shape"] += seconds["shape"];
  if (!joined) return {false, budget.spent(), {}};
  for (std::size_t k = 0; k < charts.size(); ++k) {
    const double gradient = charts.size() > 1 ? joined->projected_gradient : std::numeric_limits<double>::quiet_NaN();
    take_shape(std::move(joined->shapes[k]), gradient, stop.is_stopped(), charts[k]);
  }
  std::vector<char> is_folded = find_folded(charts);
  for (std::size_t k = 0; k < charts.size(); ++k) {
    if (is_folded[k] != 0 && replace_folded(charts, k, refine_alone, stop)) is_folded[k] = 0;
  }
  const bool is_any_folded =
      std::count(is_folded.begin(), is_folded.end(), 0) < static_cast<std::ptrdiff_t>(is_folded.size());
  if (is_any_folded && were_good(charts, before)) {
    int spent = 0;
    for (std::size_t k = 0; k < charts.size(); ++k) {
      spent += charts[k].solved.report.factorizations - before[k].report.factorizations;
      charts[k].solved = std::move(before[k]);
    }
    return {false, spent, {}};
  }
  for (const ChartToJoin& one : charts) {  // also of those that were done: together they are not
    const bool is_told = one.solved.report.termination == Termination::cancelled;
    if (stop.is_stopped() && !is_told) report_cancelled(one.solved.report);
  }
  return {true, 0, std::move(is_folded)};
}

}  // namespace wirewarp
