// SPDX-License-Identifier: GPL-3.0-or-later
#include "join_charts.h"

#include <algorithm>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "chart_errors.h"
#include "charts/seams_that_give.h"
#include "factorization_failed.h"
#include "feasibility/folded_faces.h"
#include "network/length_variation.h"
#include "piece_report.h"
#include "progress_report.h"
#include "refine/refine_chart.h"
#include "refine/refine_together.h"

namespace wirewarp {
namespace {

/// None where no common lengths are found.
std::optional<JoinedShapes> find_shapes(const std::vector<ChartToJoin>& charts, const InternalOptions& options,
                                        const StopToken& stop) {
  std::vector<Chart> copies;
  std::vector<RefinementStart> starts;
  for (const ChartToJoin& one : charts) {
    copies.push_back(one.chart);
    starts.emplace_back(one.solved.uv, one.solved.multipliers);
  }
  RefineBudget budget(options.max_factorizations);
  try {
    JoinedShapes joined = refine_together(copies, options.fairness, starts, {budget, stop.in("shape")});
    return joined.shapes.front().is_exact ? std::optional(std::move(joined)) : std::nullopt;
  } catch (const FactorizationFailed&) {
    return std::nullopt;
  } catch (const Stopped&) {
    return std::nullopt;
  }
}

/// None where nothing that is neither turned over nor over itself is found.
std::optional<RefineResult> refine_unfolded(const Chart& chart, const InternalOptions& options, const StopToken& stop) {
  try {
    RefineResult refined = refine_chart(chart, options, stop);
    const bool is_good = refined.shape.is_exact && refined.shape.injectivity == Injectivity::global;
    return is_good ? std::optional(std::move(refined)) : std::nullopt;
  } catch (const FactorizationFailed&) {
    return std::nullopt;
  } catch (const Stopped&) {
    return std::nullopt;
  }
}

/// The chart alone with its seams at these lengths, if that shape is good.
void replace_folded(const Chart& chart, const InternalOptions& options, const StopToken& stop, SolvedChart& solved) {
  if (find_folded_faces(chart.mesh, solved.uv).empty() || stop.is_stopped()) return;
  const Chart settled = with_settled_seams(chart, solved.variation);
  std::optional<RefineResult> refined = refine_unfolded(settled, options, stop);
  if (!refined) return;
  refined->factorizations += solved.report.factorizations;
  solved.report.warnings.clear();
  report_refinement(*refined, stop.is_stopped(), solved.report);
  solved.report.projected_gradient = std::numeric_limits<double>::quiet_NaN();
  solved.variation = variations_of(settled, refined->shape.variation);
  solved.uv = std::move(refined->shape.uv);
}

void take_shape(RefinedShape shape, double projected_gradient, bool was_stopped, const Chart& chart,
                SolvedChart& solved) {
  const std::string start = solved.report.start;
  RefineResult refined;
  refined.shape = std::move(shape);
  refined.shape.iterations += solved.report.outer_iterations;
  refined.start = start.c_str();
  refined.factorizations = solved.report.factorizations + refined.shape.factorizations;
  solved.report.warnings.clear();
  report_refinement(refined, was_stopped, solved.report);
  solved.report.projected_gradient = projected_gradient;
  solved.variation = variations_of(chart, refined.shape.variation);
  solved.uv = std::move(refined.shape.uv);
}

/// Without common lengths a chart keeps those at h = ease; without a shape at these it has the error of before.
void keep_settled(const ChartToJoin& one, bool was_stopped) {
  PieceReport& report = one.solved.report;
  if (one.settled_error) {
    report.termination = was_stopped ? Termination::cancelled : Termination::failed;
    one.solved.uv.resize(0, 2);
    one.solved.network.reset();
    one.solved.error = was_stopped ? cancelled() : *one.settled_error;
  } else if (!was_stopped) {
    report.warnings.push_back(
        "No good shapes were found with other lengths of the seams that give: they have those of their ease.");
    report.termination = Termination::stalled;
  }
}

bool is_folded(const ChartToJoin& one) { return !find_folded_faces(one.chart.mesh, one.solved.uv).empty(); }

}  // namespace

void join_charts(const std::vector<ChartToJoin>& charts, const InternalOptions& options, const StopToken& stop) {
  std::vector<SolvedChart> settled;
  for (const ChartToJoin& one : charts) settled.push_back(one.solved);
  const bool were_good = std::none_of(charts.begin(), charts.end(),
                                      [](const ChartToJoin& one) { return one.settled_error || is_folded(one); });
  std::optional<JoinedShapes> joined;
  std::map<std::string, double> seconds;
  {
    const StageTimer timer(seconds, "shape");
    joined = find_shapes(charts, options, stop);
  }
  charts.front().solved.report.seconds["shape"] += seconds["shape"];
  for (std::size_t k = 0; k < charts.size(); ++k) {
    const ChartToJoin& one = charts[k];
    if (!joined) {
      keep_settled(one, stop.is_stopped());
      continue;
    }
    take_shape(std::move(joined->shapes[k]), joined->projected_gradient, stop.is_stopped(), one.chart, one.solved);
    replace_folded(one.chart, options, stop, one.solved);
    if (!is_folded(one)) one.solved.proposed_seams.clear();
  }
  if (were_good && std::any_of(charts.begin(), charts.end(), is_folded)) {  // good pieces come before less distortion
    for (std::size_t k = 0; k < charts.size(); ++k) {
      charts[k].solved = std::move(settled[k]);
      keep_settled(charts[k], stop.is_stopped());
    }
  }
  if (!stop.is_stopped()) return;
  for (const ChartToJoin& one : charts) {  // also of those that were done: together they are not
    if (one.solved.report.termination != Termination::cancelled) report_cancelled(one.solved.report);
  }
}

}  // namespace wirewarp
