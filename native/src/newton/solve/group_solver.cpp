// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/solve/group_solver.h"

#include <algorithm>
#include <utility>

#include "base/progress_report.h"
#include "newton/injective_shape.h"
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

GroupSolver::Outcome GroupSolver::solve_together() {
  std::vector<Part> parts;
  for (std::size_t k = 0; k < group_.size(); ++k) parts.push_back({k, group_[k].chart});
  return solve(parts, std::all_of(group_.begin(), group_.end(), [](const auto& member) { return member.is_nominal; }));
}

GroupSolver::Outcome GroupSolver::solve(const std::vector<Part>& parts, bool keeps_good) {
  if (!stop_.may_go_on()) return {};
  std::vector<int> left;
  for (const Part& part : parts) {
    left.push_back(run_.options.max_factorizations - (renews_limit_ ? 0 : solved(part).report.factorizations));
  }
  Budget budget(*std::min_element(left.begin(), left.end()));
  if (!take_common_shapes(parts, budget)) return {false, budget.ran_out()};
  Outcome outcome{true, budget.ran_out(), find_folded(parts)};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (outcome.is_folded[i] == 0) continue;
    Budget own(left[i] - budget.spent());
    if (replace_folded(parts[i], own)) outcome.is_folded[i] = 0;
    outcome.ran_out = outcome.ran_out || own.ran_out();
  }
  const bool is_any_folded = std::count(outcome.is_folded.begin(), outcome.is_folded.end(), 1) > 0;
  outcome.is_solved = !(is_any_folded && keeps_good && were_good(parts));
  for (const Part& part : parts) {
    if (!outcome.is_solved) {
      before_[part.member].report.factorizations = solved(part).report.factorizations;
      solved(part) = before_[part.member];
    } else if (stop_.is_stopped()) {
      report_cancelled(solved(part).report);  // even if this chart is finished, because its group is not
    }
  }
  return outcome;
}

std::vector<char> GroupSolver::find_folded(const std::vector<Part>& parts) const {
  std::vector<char> folded;
  for (const Part& part : parts) folded.push_back(has_folds(part.chart, solved(part).uv) ? 1 : 0);
  return folded;
}

bool GroupSolver::were_good(const std::vector<Part>& parts) const {
  return std::none_of(parts.begin(), parts.end(),
                      [&](const Part& part) { return has_folds(part.chart, before_[part.member].uv); });
}

/// Solves the parts together. Returns false if no common lengths are found. Each factorization counts for every part.
bool GroupSolver::take_common_shapes(const std::vector<Part>& parts, Budget& budget) {
  std::vector<CoupledChart> charts;
  for (const Part& part : parts) {
    const TargetLengths* lengths = run_.options.cloth ? &group_[part.member].lengths : nullptr;
    charts.push_back({part.chart, lengths, {solved(part).uv, {}, solved(part).multipliers}});
  }
  const Stage stage = run_.options.cloth ? Stage{&*run_.options.cloth, nullptr, Injectivity::local} : Stage{};
  const StageTimer timer(solved(parts.front()).report.seconds, "shape");
  std::vector<Solution> found = refine_coupled(charts, run_.options.fairness, stage, {budget, stop_});
  const bool is_exact = found.front().is_exact();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    SolvedChart& one = solved(parts[i]);
    if (!is_exact) {
      one.report.factorizations += budget.spent();
      continue;
    }
    report_next_refinement(found[i], stop_.is_stopped(), one.report);
    one.variation = variations_of(parts[i].chart, found[i].shape.variation);
    one.uv = std::move(found[i].shape.uv);
  }
  return is_exact;
}

/// Replaces a folded shape by an injective one with the same lengths of its seams. Returns false, and keeps the folded
/// shape, if none is found.
bool GroupSolver::replace_folded(const Part& part, Budget& budget) {
  if (stop_.is_stopped()) return false;
  SolvedChart& one = solved(part);
  const Chart fixed = with_fixed_seams(part.chart, one.variation);
  Solution refined = refine_injective_(part.member, fixed, budget);
  one.report.factorizations += budget.spent();
  if (!refined.is_exact() || injectivity_of(fixed, refined.shape.uv) != Injectivity::global) return false;
  one.report.warnings.clear();
  report_refinement(refined, one.report.factorizations, stop_.is_stopped(), one.report);
  one.variation = variations_of(fixed, refined.shape.variation);
  one.uv = std::move(refined.shape.uv);
  return true;
}

bool has_folds(const Chart& chart, const Positions2& uv) { return !find_folded_faces(chart.mesh, uv).empty(); }

}  // namespace wirewarp
