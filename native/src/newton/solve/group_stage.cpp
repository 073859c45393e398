// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/solve/group_stage.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "base/attempt.h"
#include "base/progress_report.h"
#include "newton/injective_shape.h"
#include "newton/refine_cloth.h"
#include "newton/refine_coupled.h"
#include "newton/solve/chart_errors.h"
#include "newton/solve/piece_report.h"
#include "surface/charts/elastic_seams.h"
#include "surface/charts/folded_faces.h"
#include "surface/network/length_variation.h"

namespace wirewarp {
namespace {

class GroupStage {
 public:
  GroupStage(const std::vector<GroupMember>& group, bool is_stretched, const Run& run, const StopToken& stop)
      : group_(group), is_stretched_(is_stretched), run_(run), stop_(stop.in("shape")) {
    for (const GroupMember& member : group) {
      before_.push_back(member.solved);
      if (!run.options.cloth) continue;
      lengths_.push_back({{hold_upright(member.chart, member.solved.uv, run.options)}, member.flat_ratio});
      if (is_stretched) lengths_.back().flat_share = flat_share(*run.options.cloth);
    }
  }

  void solve() {
    std::vector<Part> together;
    for (std::size_t k = 0; k < group_.size(); ++k) together.push_back({k, group_[k].chart});
    const bool are_nominal = std::all_of(group_.begin(), group_.end(), [](const auto& one) { return one.is_nominal; });
    const Outcome common = solve_parts(together, are_nominal);
    for (std::size_t k = 0; k < group_.size(); ++k) {
      if (common.is_solved) {
        finish(k, group_[k].chart, common.is_folded[k] != 0);
      } else {
        solve_with_fixed_seams(k, common.ran_out);
      }
    }
  }

 private:
  /// A chart of the group, perhaps with fixed seams.
  struct Part {
    std::size_t member;
    const Chart& chart;
  };

  struct Outcome {
    bool is_solved;               // otherwise the shapes are those from before the stage
    bool ran_out;                 // a solver needed more factorizations than the limit allowed
    std::vector<char> is_folded;  // per part, if solved: flipped or overlapping
  };

  SolvedChart& solved(std::size_t k) const { return group_[k].solved; }
  static bool has_folds(const Chart& chart, const Positions2& uv) { return !find_folded_faces(chart.mesh, uv).empty(); }

  /// Finds the common lengths and the shapes. keeps_good: if a part is folded although none was before, all keep the
  /// shapes from before.
  Outcome solve_parts(const std::vector<Part>& parts, bool keeps_good) {
    if (!stop_.may_go_on()) return {false, false, {}};
    // Each attempt at a stretch may spend the whole limit, because a piece without a shape for it is lost.
    std::vector<int> limits;
    int left = std::numeric_limits<int>::max();
    for (const Part& part : parts) {
      const int spent = solved(part.member).report.factorizations;
      limits.push_back(run_.options.max_factorizations + (is_stretched_ ? spent : 0));
      left = std::min(left, limits.back() - spent);
    }
    Budget budget(left);
    if (!take_common_shapes(parts, budget)) return {false, budget.ran_out(), {}};
    Outcome outcome{true, budget.ran_out(), find_folded(parts)};
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (outcome.is_folded[i] == 0) continue;
      Budget own(limits[i] - solved(parts[i].member).report.factorizations);
      if (replace_folded(parts[i], own)) outcome.is_folded[i] = 0;
      outcome.ran_out = outcome.ran_out || own.ran_out();
    }
    const bool is_any_folded = std::count(outcome.is_folded.begin(), outcome.is_folded.end(), 1) > 0;
    outcome.is_solved = !(is_any_folded && keeps_good && were_good(parts));
    for (const Part& part : parts) {
      if (!outcome.is_solved) {
        before_[part.member].report.factorizations = solved(part.member).report.factorizations;
        solved(part.member) = before_[part.member];
      } else if (stop_.is_stopped()) {
        report_as_cancelled(part.member);  // even if this chart was finished: the group is not
      }
    }
    return outcome;
  }

  std::vector<char> find_folded(const std::vector<Part>& parts) const {
    std::vector<char> folded;
    for (const Part& part : parts) folded.push_back(has_folds(part.chart, solved(part.member).uv) ? 1 : 0);
    return folded;
  }

  bool were_good(const std::vector<Part>& parts) const {
    return std::none_of(parts.begin(), parts.end(),
                        [&](const Part& part) { return has_folds(part.chart, before_[part.member].uv); });
  }

  /// Returns false if there are no common lengths. Each factorization counts for each of the parts.
  bool take_common_shapes(const std::vector<Part>& parts, Budget& budget) {
    std::vector<Chart> charts;
    std::vector<TargetLengths> lengths;
    std::vector<Shape> starts;
    for (const Part& part : parts) {
      charts.push_back(part.chart);
      starts.push_back({solved(part.member).uv, {}, solved(part.member).multipliers});
      if (run_.options.cloth) lengths.push_back(lengths_[part.member]);
    }
    const Stage stage = run_.options.cloth ? Stage{&*run_.options.cloth, nullptr, Injectivity::local} : Stage{};
    const StageTimer timer(solved(parts.front().member).report.seconds, "shape");
    CoupledSolution found = refine_coupled(charts, run_.options.fairness, stage, lengths, starts, {budget, stop_});
    const bool is_exact = found.charts.front().is_exact();
    for (std::size_t i = 0; i < parts.size(); ++i) {
      SolvedChart& one = solved(parts[i].member);
      if (!is_exact) {
        one.report.factorizations += budget.spent();
        continue;
      }
      report_next_refinement(found.charts[i], stop_.is_stopped(), one.report);
      one.report.projected_gradient = parts.size() > 1 ? found.projected_gradient : kUnknown;
      one.variation = variations_of(parts[i].chart, found.charts[i].shape.variation);
      one.uv = std::move(found.charts[i].shape.uv);
    }
    return is_exact;
  }

  /// Solves a folded chart by itself, with its elastic seams fixed at the common lengths. Returns false if the shape is
  /// folded again, and keeps the old one then.
  bool replace_folded(const Part& part, Budget& budget) {
    if (stop_.is_stopped()) return false;
    SolvedChart& one = solved(part.member);
    const Chart fixed = with_fixed_seams(part.chart, one.variation);
    std::optional<Solution> refined = is_stretched_ ? refine_without_overlap(part.member, fixed, budget)
                                                    : refine_injective(fixed, run_.options, {budget, stop_});
    one.report.factorizations += budget.spent();
    if (!refined) return false;
    one.report.warnings.clear();
    report_refinement(*refined, one.report.factorizations, stop_.is_stopped(), one.report);
    one.report.projected_gradient = kUnknown;
    one.variation = variations_of(fixed, refined->shape.variation);
    one.uv = std::move(refined->shape.uv);
    return true;
  }

  /// Starts from the shape before the stage and allows no overlaps on the way.
  std::optional<Solution> refine_without_overlap(std::size_t k, const Chart& fixed, Budget& budget) const {
    if (injectivity_of(fixed, before_[k].uv) != Injectivity::global) return std::nullopt;
    Solution refined =
        refine_coupled({fixed}, run_.options.fairness, {&*run_.options.cloth, nullptr, Injectivity::global},
                       {lengths_[k]}, {Shape{before_[k].uv}}, {budget, stop_})
            .charts.front();
    if (!refined.is_exact() || injectivity_of(fixed, refined.shape.uv) != Injectivity::global) return std::nullopt;
    refined.start = before_[k].report.start.c_str();
    refined.iterations += before_[k].report.outer_iterations;
    return refined;
  }

  /// Solves a chart by itself, with its elastic seams fixed at h = ease. ran_out: the group ran out of factorizations.
  void solve_with_fixed_seams(std::size_t k, bool ran_out) {
    const Chart fixed = with_fixed_seams(group_[k].chart);
    Outcome outcome{false, false, {}};
    if (group_[k].is_nominal) outcome = solve_parts({{k, fixed}}, false);
    if (outcome.is_solved) {
      finish(k, fixed, outcome.is_folded.front() != 0);
      report_as_fixed(k);
    } else if (is_stretched_) {
      explain_stretch(k, ran_out || outcome.ran_out);
    } else if (group_[k].is_nominal && stop_.is_stopped()) {
      report_as_cancelled(k);
    } else if (group_[k].is_nominal) {  // keeps its shape from before the stage
      finish(k, fixed, has_folds(fixed, solved(k).uv));
      report_as_fixed(k);
    } else {
      solve_anew(k);
    }
  }

  /// Sets what follows from a new shape. chart: the chart that has this shape.
  void finish(std::size_t k, const Chart& chart, bool is_folded) {
    if (is_stretched_) set_stretched_lengths(k, group_[k].chart);
    if (is_folded) propose_seams_for_layout(is_stretched_ ? group_[k].chart : chart, run_, stop_, solved(k));
    if (is_stretched_) lie_flat(k);
  }

  void report_as_fixed(std::size_t k) const {
    if (solved(k).report.termination != Termination::cancelled) report_fixed_seams(solved(k).report);
  }

  void report_as_cancelled(std::size_t k) const {
    if (solved(k).report.termination != Termination::cancelled) report_cancelled(solved(k).report);
  }

  /// Solves a chart from scratch at h = ease, where it had no shape, for its error.
  void solve_anew(std::size_t k) const {
    Budget budget(run_.options.max_factorizations);
    budget.spend(solved(k).report.factorizations);
    solved(k) =
        stop_.is_stopped() ? cancelled_chart() : solve_chart_with_fixed_seams(group_[k].chart, run_, budget, stop_);
    solved(k).report.factorizations = budget.spent();
    if (!solved(k).error) report_as_fixed(k);
  }

  /// Replaces the layout by an error. Its proposed seams are evaluated at the stretched lengths; others would not help.
  void explain_stretch(std::size_t k, bool ran_out) const {
    if (injectivity_of(group_[k].chart, before_[k].uv) != Injectivity::global && !stop_.is_stopped()) return;
    Chart stretched = group_[k].chart;
    set_stretched_lengths(k, stretched);
    std::vector<VertexPair> seams;
    if (!stop_.is_stopped()) seams = attempt([&] { return propose_seams(stretched, run_, stop_); });
    SolvedChart& one = solved(k);
    one.uv.resize(0, 2);
    one.network.reset();
    one.proposed_seams.clear();
    one.report.termination = stop_.is_stopped() ? Termination::cancelled : Termination::failed;
    one.error = stop_.is_stopped() ? cancelled() : infeasible_stretch(stretched, run_.options, seams, ran_out);
  }

  void set_stretched_lengths(std::size_t k, Chart& chart) const {
    const PerEdge& ratio = group_[k].flat_ratio;
    chart.length_ratio.resize(chart.mesh.n_edges(), 1);
    for (std::size_t e = 0; e < ratio.size(); ++e) chart.length_ratio[e] *= ratio[e];
  }

  /// Turns the layout in the plane of the stretched cloth into the flat one.
  void lie_flat(std::size_t k) const {
    SolvedChart& one = solved(k);
    const Chart& chart = group_[k].chart;
    const Eigen::RowVector2d share = flat_share(*run_.options.cloth);
    one.report.objective *= share.prod();  // per flat area
    one.uv = one.uv * share.asDiagonal();
    one.network = build_wire_network(chart);
    const std::vector<double> flat = variations_of(chart, length_variation(chart, one.uv));
    for (std::size_t i = 0; i < flat.size(); ++i) {
      if (chart.wire_parts[i].kind == WireKind::super_elastic) one.variation[i] = flat[i];
    }
  }

  static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

  const std::vector<GroupMember>& group_;
  const bool is_stretched_;
  const Run& run_;
  const StopToken stop_;
  std::vector<SolvedChart> before_;     // per member, before the stage
  std::vector<TargetLengths> lengths_;  // per member, if there is a cloth
};

}  // namespace

void free_elastic_seams(const std::vector<GroupMember>& group, const Run& run, const StopToken& stop) {
  GroupStage(group, false, run, stop).solve();
}

void stretch_group(const std::vector<GroupMember>& group, const Run& run, const StopToken& stop) {
  GroupStage(group, true, run, stop).solve();
}

}  // namespace wirewarp
