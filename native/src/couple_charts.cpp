// SPDX-License-Identifier: GPL-3.0-or-later
#include "couple_charts.h"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "charts/elastic_seams.h"
#include "feasibility/folded_faces.h"
#include "network/length_variation.h"
#include "piece_report.h"
#include "progress_report.h"
#include "refine/injective_shape.h"
#include "refine/refine_chart.h"
#include "refine/refine_cloth.h"
#include "refine/refine_coupled.h"

namespace wirewarp {
namespace {

std::vector<char> find_folded(const std::vector<CoupledChart>& charts) {
  std::vector<char> is_folded;
  for (const CoupledChart& one : charts) {
    is_folded.push_back(find_folded_faces(one.chart.mesh, one.solved.uv).empty() ? 0 : 1);
  }
  return is_folded;
}

/// None where no common lengths are found.
std::optional<CoupledShapes> find_shapes(const std::vector<CoupledChart>& charts, const InternalOptions& options,
                                         RefineBudget& budget, const StopToken& stop) {
  std::vector<Chart> copies;
  std::vector<ClothOnChart> cloths;
  std::vector<RefinementStart> starts;
  for (const CoupledChart& one : charts) {
    copies.push_back(one.chart);
    starts.emplace_back(one.solved.uv, one.solved.multipliers);
    if (one.cloth) cloths.push_back(*one.cloth);
  }
  const Injectivity injectivity = options.cloth ? Injectivity::local : Injectivity::none;
  CoupledShapes coupled =
      refine_coupled(copies, options.fairness, cloths, starts, {budget, stop.in("shape"), injectivity});
  return coupled.shapes.front().is_exact() ? std::optional(std::move(coupled)) : std::nullopt;
}

/// The chart alone with its seams at these lengths, if that shape is good. Whether it is.
bool replace_folded(const std::vector<CoupledChart>& charts, std::size_t index, const RefineAlone& refine_alone,
                    RefineBudget& budget, const StopToken& stop) {
  if (stop.is_stopped()) return false;
  SolvedChart& solved = charts[index].solved;
  const Chart fixed = with_fixed_seams(charts[index].chart, solved.variation);
  std::optional<RefineResult> refined = refine_alone(index, fixed, budget, stop);
  solved.report.factorizations += budget.spent();
  if (!refined) return false;
  refined->factorizations = solved.report.factorizations;
  solved.report.warnings.clear();
  report_refinement(*refined, stop.is_stopped(), solved.report);
  solved.report.projected_gradient = std::numeric_limits<double>::quiet_NaN();
  solved.variation = variations_of(fixed, refined->shape.variation);
  solved.uv = std::move(refined->shape.uv);
  return true;
}

void take_shape(RefinedShape shape, double projected_gradient, bool was_stopped, const CoupledChart& one) {
  SolvedChart& solved = one.solved;
  report_next_refinement(shape, was_stopped, solved.report);
  solved.report.projected_gradient = projected_gradient;
  solved.variation = variations_of(one.chart, shape.variation);
  solved.uv = std::move(shape.uv);
}

/// Whether all were at h = ease, and none flipped or overlapping.
bool were_good(const std::vector<CoupledChart>& charts, const std::vector<SolvedChart>& before) {
  for (std::size_t k = 0; k < charts.size(); ++k) {
    if (!charts[k].is_nominal_good || !find_folded_faces(charts[k].chart.mesh, before[k].uv).empty()) return false;
  }
  return true;
}

}  // namespace

std::optional<RefineResult> refine_injective(const Chart& chart, const InternalOptions& options, RefineBudget& budget,
                                             const StopToken& stop) {
  RefineResult refined = refine_chart(chart, options, budget, stop);
  if (refined.shape.is_exact() && !refined.shape.injectivity) {  // not known without mends_folds
    refined.shape.injectivity = injectivity_of(chart, refined.shape.uv);
  }
  const bool is_good = refined.shape.is_exact() && refined.shape.injectivity == Injectivity::global;
  if (is_good && options.cloth) refine_cloth(chart, options, budget, stop.in("shape"), refined);
  return is_good ? std::optional(std::move(refined)) : std::nullopt;
}

CouplingOutcome couple_charts(const std::vector<CoupledChart>& charts, const InternalOptions& options,
                              const RefineAlone& refine_alone, const StopToken& stop) {
  std::vector<SolvedChart> before;
  for (const CoupledChart& one : charts) before.push_back(one.solved);
  int left = charts.front().factorizations_left();
  for (const CoupledChart& one : charts) left = std::min(left, one.factorizations_left());
  RefineBudget budget(left);
  std::optional<CoupledShapes> coupled;
  std::map<std::string, double> seconds;
  {
    const StageTimer timer(seconds, "shape");
    coupled = find_shapes(charts, options, budget, stop);
  }
  charts.front().solved.report.seconds["shape"] += seconds["shape"];
  if (!coupled) {
    for (const CoupledChart& one : charts) one.solved.report.factorizations += budget.spent();
    return {false, budget.ran_out(), {}};
  }
  bool ran_out = budget.ran_out();
  for (std::size_t k = 0; k < charts.size(); ++k) {
    const double gradient = charts.size() > 1 ? coupled->projected_gradient : std::numeric_limits<double>::quiet_NaN();
    take_shape(std::move(coupled->shapes[k]), gradient, stop.is_stopped(), charts[k]);
  }
  std::vector<char> is_folded = find_folded(charts);
  for (std::size_t k = 0; k < charts.size(); ++k) {
    if (is_folded[k] == 0) continue;
    RefineBudget own(charts[k].factorizations_left());
    if (replace_folded(charts, k, refine_alone, own, stop)) is_folded[k] = 0;
    ran_out = ran_out || own.ran_out();
  }
  const bool is_any_folded =
      std::count(is_folded.begin(), is_folded.end(), 0) < static_cast<std::ptrdiff_t>(is_folded.size());
  if (is_any_folded && were_good(charts, before)) {
    for (std::size_t k = 0; k < charts.size(); ++k) {
      before[k].report.factorizations = charts[k].solved.report.factorizations;
      charts[k].solved = std::move(before[k]);
    }
    return {false, ran_out, {}};
  }
  for (const CoupledChart& one : charts) {  // also of those that were done: together they are not
    const bool is_told = one.solved.report.termination == Termination::cancelled;
    if (stop.is_stopped() && !is_told) report_cancelled(one.solved.report);
  }
  return {true, ran_out, std::move(is_folded)};
}

}  // namespace wirewarp
