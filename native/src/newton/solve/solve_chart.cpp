// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/solve/solve_chart.h"

#include <map>
#include <utility>

#include "base/attempt.h"
#include "base/factorization_failed.h"
#include "base/progress_report.h"
#include "newton/infeasible_wires.h"
#include "newton/refine_chart.h"
#include "newton/solve/chart_errors.h"
#include "newton/solve/piece_report.h"
#include "surface/charts/folded_faces.h"
#include "surface/charts/isoperimetric.h"
#include "surface/network/length_variation.h"
#include "warp/outer/choose_variation.h"
#include "warp/outer/helper_wires.h"
#include "warp/topology/process_topology.h"
#include "warp/topology/unjoined_wires.h"

namespace wirewarp {
namespace {

/// Returns the error of a chart for which no shape with all lengths was found. Without run.propose_seams, nobody reads
/// the error, so it names the outline without a diagnosis. Throws Stopped and FactorizationFailed.
FlattenError explain_infeasible(Problem& problem, const Run& run, SolutionStatus status, const Budget& budget,
                                const StopToken& stop) {
  const Chart& chart = problem.chart();
  if (status == SolutionStatus::singular) return not_solvable(chart);
  LengthDiagnosis found;
  if (run.propose_seams) found = diagnose_lengths(problem, run.options, stop);
  stop.check();
  const bool ran_out = budget.ran_out() && !found.lengths_conflict;
  if (found.tolerances.empty()) return infeasible_outline(chart, run.options, seams_for(chart, run, stop), ran_out);
  return infeasible_wires(chart, run.input.wires, run.options, std::move(found.tolerances), ran_out);
}

/// Solves by WireWarping or WireWarping++: the wires first, then the surface (paper II).
std::optional<FlattenError> flatten_by_warping(const Chart& chart, const Run& run, Budget& budget,
                                               const StopToken& stop, SolvedChart& solved) {
  std::map<std::string, double>& seconds = solved.report.seconds;
  if (run.options.method == Method::wirewarp_plus_plus) {
    if (std::optional<FlattenError> error = elastic_outline(chart, run.input.wires)) return error;
  }
  stop.in("wires").check();
  std::optional<Chart> split;
  WireNetwork network;
  {
    const StageTimer timer(seconds, "wires");
    split = process_topology(chart, stop.in("wires"));  // paper III
    network = build_wire_network(split ? *split : chart);
  }
  const Chart& prepared = split ? *split : chart;
  stop.in("interior").check();
  const StopToken at_lengths = stop.in("lengths");
  std::optional<Warp> warp;  // ψ (paper II-A)
  {
    const StageTimer timer(seconds, "interior");
    warp.emplace(prepared, network, run.options.node_weight, run.options.inner, at_lengths);
    solved.report.factorizations = warp->interior_factorizations();
  }
  const StageTimer timer(seconds, "lengths");
  const VariationBounds bounds = variation_bounds(prepared, run.options);
  OuterSolution solution = choose_variation(prepared, *warp, bounds);  // paper II-B, Algorithm 1
  report_solution(solution, solved.report);
  if (!solution.shape.inner.is_feasible) {
    const StopToken in_no_other_stage([&](const char*) { return at_lengths.may_go_on(); });
    Problem problem(chart, run.options.fairness);
    const Solution refined = refine_chart(problem, run.options, {budget, in_no_other_stage});
    if (stop.is_stopped()) throw Stopped();
    if (refined.is_exact()) return needs_refinement(chart);
    return explain_infeasible(problem, run, refined.status, budget, in_no_other_stage);
  }
  solved.helper_wires = list_helper_wires(prepared, chart.wire_parts.size(), solution.variation);
  solved.variation = variations_of(chart, solution.variation);
  solved.uv = std::move(solution.shape.uv);
  if (has_folds(chart.mesh, solved.uv) && !lies_flat(chart, run.options, stop))
    solved.proposed_seams = seams_for(chart, run, stop);
  return std::nullopt;
}

/// Solves by the refined method, which finds wires and surface together, with exact lengths. If the caller stops after
/// the lengths became exact, keeps the best shape so far.
std::optional<FlattenError> flatten_by_refining(const Chart& chart, const Run& run, Budget& budget,
                                                const StopToken& stop, SolvedChart& solved) {
  stop.in("start").check();
  const StageTimer timer(solved.report.seconds, "shape");
  Problem problem(chart, run.options.fairness);
  Solution refined = refine_chart(problem, run.options, {budget, stop});
  if (refined.status == SolutionStatus::cancelled) throw Stopped();
  report_refinement(refined, budget.spent(), stop.is_stopped(), solved.report);
  if (!refined.is_exact()) return explain_infeasible(problem, run, refined.status, budget, stop.in("shape"));
  solved.variation = variations_of(chart, refined.shape.variation);
  solved.multipliers = std::move(refined.shape.multipliers);
  solved.uv = std::move(refined.shape.uv);
  const bool is_folded = refined.injectivity != Injectivity::global;
  if (is_folded && !stop.is_stopped()) solved.proposed_seams = seams_for(chart, run, stop);
  return std::nullopt;
}

}  // namespace

std::vector<VertexPair> seams_for(const Chart& chart, const Run& run, const StopToken& stop) {
  return run.propose_seams ? run.propose_seams(chart, stop) : std::vector<VertexPair>{};
}

void propose_seams_for_layout(const Chart& chart, const Run& run, const StopToken& stop, SolvedChart& solved) {
  if (stop.is_stopped()) return;
  solved.proposed_seams = attempt([&] { return seams_for(chart, run, stop); });
  if (stop.is_stopped()) report_cancelled(solved.report);
}

SolvedChart cancelled_chart() {
  SolvedChart solved;
  solved.error = cancelled();
  solved.report.termination = Termination::cancelled;
  return solved;
}

SolvedChart solve_chart(const Chart& chart, const Run& run, Budget& budget, const StopToken& stop) {
  SolvedChart solved;
  try {
    if (chart.error) {
      solved.error = with_proposed_seams(*chart.error, seams_for(chart, run, stop));
    } else if (is_outline_too_short(chart)) {
      solved.error = outline_too_short(chart, seams_for(chart, run, stop));
    } else {
      const auto flatten = run.options.method == Method::refined ? flatten_by_refining : flatten_by_warping;
      solved.error = flatten(chart, run, budget, stop, solved);
    }
  } catch (const Stopped&) {
    solved = cancelled_chart();
  } catch (const UnjoinedWires&) {
    solved.error = not_joined(chart);
  } catch (const FactorizationFailed&) {
    solved.error = not_solvable(chart);
  }
  return solved;
}

}  // namespace wirewarp
