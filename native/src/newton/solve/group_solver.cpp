// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/solve/group_solver.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "base/progress_report.h"
#include "newton/refine_coupled.h"
#include "newton/solve/piece_report.h"
#include "surface/charts/elastic_seams.h"
#include "surface/charts/folded_faces.h"
#include "surface/network/length_variation.h"

namespace wirewarp {

GroupSolver::GroupSolver(const std::vector<GroupMember>& group, const Run& run, const StopToken& stop,
                         bool renews_limit, RefineInjective refine_injective)
    : group_(group),
      run_(run),
      stop_(stop),
      renews_limit_(renews_limit),
      refine_injective_(std::move(refine_injective)) {
  for (const GroupMember& member : group) before_.push_back(member.solved);
}

GroupSolver::Outcome GroupSolver::solve(std::optional<std::size_t> alone) {
  if (!stop_.may_go_on()) return {};
  std::vector<std::size_t> members(alone ? 1 : group_.size());
  std::iota(members.begin(), members.end(), alone.value_or(0));
  std::vector<int> left;
  for (const std::size_t k : members) {
    left.push_back(run_.options.max_factorizations - (renews_limit_ ? 0 : group_[k].solved.report.factorizations));
  }
  Budget budget(*std::min_element(left.begin(), left.end()));
  if (!take_common_shapes(members, budget)) return {false, budget.ran_out()};
  Outcome outcome{true, budget.ran_out()};
  for (std::size_t i = 0; i < members.size(); ++i) {
    const GroupMember& member = group_[members[i]];
    outcome.is_folded.push_back(has_folds(member.chart.mesh, member.solved.uv) ? 1 : 0);
    if (outcome.is_folded[i] == 0) continue;
    Budget own(left[i] - budget.spent());
    if (replace_folded(members[i], own)) outcome.is_folded[i] = 0;
    outcome.ran_out = outcome.ran_out || own.ran_out();
  }
  const bool is_any_folded = std::count(outcome.is_folded.begin(), outcome.is_folded.end(), 1) > 0;
  const auto was_good_at_ease = [&](std::size_t k) { return group_[k].is_nominal && was_good(k); };
  outcome.is_solved = alone || !is_any_folded || !std::all_of(members.begin(), members.end(), was_good_at_ease);
  for (const std::size_t k : members) {
    SolvedChart& one = group_[k].solved;
    if (!outcome.is_solved) {
      before_[k].report.factorizations = one.report.factorizations;
      one = before_[k];
    } else if (stop_.is_stopped()) {
      report_cancelled(one.report);  // even if this chart is finished, because its group is not
    }
  }
  return outcome;
}

bool GroupSolver::was_good(std::size_t member) const {
  return !has_folds(group_[member].chart.mesh, before_[member].uv);
}

/// Solves the charts together. Returns false if no common lengths are found. Each factorization counts for every chart.
bool GroupSolver::take_common_shapes(const std::vector<std::size_t>& members, Budget& budget) {
  std::vector<CoupledChart> charts;
  for (const std::size_t k : members) {
    const auto& [chart, solved, is_nominal, lengths] = group_[k];
    charts.push_back({chart, run_.options.cloth ? &lengths : nullptr, {solved.uv, {}, solved.multipliers}});
  }
  const Stage stage = run_.options.cloth ? Stage{&*run_.options.cloth, nullptr, Injectivity::local} : Stage{};
  const StageTimer timer(group_[members.front()].solved.report.seconds, "shape");
  std::vector<Solution> found = refine_coupled(charts, run_.options.fairness, stage, {budget, stop_});
  const bool is_exact = found.front().is_exact();
  for (std::size_t i = 0; i < members.size(); ++i) {
    const GroupMember& member = group_[members[i]];
    member.solved.report.factorizations += budget.spent();
    if (!is_exact) continue;
    report_next_refinement(found[i], stop_.is_stopped(), member.solved.report);
    take_shape(found[i].shape, member);
  }
  return is_exact;
}

/// Replaces a folded shape with an injective shape. The elastic seams keep the lengths of the folded shape. Returns
/// false, and keeps the folded shape, if no injective shape is found.
bool GroupSolver::replace_folded(std::size_t member, Budget& budget) {
  if (stop_.is_stopped()) return false;
  const auto& [chart, solved, is_nominal, lengths] = group_[member];
  const FixedSeams fixed(chart, solved.variation);
  Solution refined = refine_injective_(member, budget);
  solved.report.factorizations += budget.spent();
  if (!refined.is_exact() || has_folds(chart.mesh, refined.shape.uv)) return false;
  solved.report.warnings.clear();
  report_refinement(refined, solved.report.factorizations, stop_.is_stopped(), solved.report);
  take_shape(refined.shape, group_[member]);
  return true;
}

void take_shape(Shape& shape, const GroupMember& member) {
  member.solved.variation = variations_of(member.chart, shape.variation);
  member.solved.uv = std::move(shape.uv);
}

}  // namespace wirewarp
