// SPDX-License-Identifier: GPL-3.0-or-later
#include "join_charts.h"

#include <map>
#include <string>
#include <utility>

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
    if (joined.shapes.front().is_exact) return joined;
  } catch (const FactorizationFailed&) {  // the shapes at h = ease are good
  } catch (const Stopped&) {
  }
  return std::nullopt;
}

/// The chart alone with its seams at these lengths, if that shape is neither turned over nor over itself.
void replace_folded(const Chart& chart, const InternalOptions& options, const StopToken& stop, SolvedChart& solved) {
  if (find_folded_faces(chart.mesh, solved.uv).empty() || stop.is_stopped()) return;
  const Chart settled = with_settled_seams(chart, solved.variation);
  try {
    RefineResult refined = refine_chart(settled, options, stop);
    solved.report.factorizations += refined.factorizations;
    if (!refined.shape.is_exact || refined.shape.injectivity != Injectivity::global) return;
    solved.variation = variations_of(settled, refined.shape.variation);
    solved.uv = std::move(refined.shape.uv);
    solved.report.start = refined.start;
  } catch (const FactorizationFailed&) {  // it keeps the shape that it has
  } catch (const Stopped&) {
  }
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

void refuse(const ChartToJoin& one) {
  if (!one.settled_error) return;
  PieceReport report = std::move(one.solved.report);
  report.termination = Termination::failed;
  one.solved = {};
  one.solved.report = std::move(report);
  one.solved.error = one.settled_error;
}

}  // namespace

void join_charts(const std::vector<ChartToJoin>& charts, const InternalOptions& options, const StopToken& stop) {
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
      refuse(one);
      if (stop.is_stopped()) one.solved.report.termination = Termination::cancelled;
      continue;
    }
    take_shape(std::move(joined->shapes[k]), joined->projected_gradient, stop.is_stopped(), one.chart, one.solved);
    replace_folded(one.chart, options, stop, one.solved);
  }
}

}  // namespace wirewarp
