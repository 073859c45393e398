// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/solve/stretch_charts.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "base/attempt.h"
#include "newton/refine_cloth.h"
#include "newton/refine_coupled.h"
#include "newton/solve/chart_errors.h"
#include "newton/solve/charts_progress.h"
#include "newton/solve/group_solver.h"
#include "newton/solve/piece_report.h"
#include "newton/solve/solve_charts.h"
#include "newton/solve/stretched_lengths.h"
#include "surface/charts/elastic_seams.h"
#include "surface/charts/folded_faces.h"
#include "surface/network/length_variation.h"
#include "surface/orientation/upright_direction.h"

namespace wirewarp {
namespace {

/// Solves a coupled group, or some of its charts. Layouts are in the plane of the stretched fabric until finish().
class StretchedGroup {
 public:
  StretchedGroup(const std::vector<GroupMember>& group, const Run& run, const StopToken& stop)
      : group_(group),
        run_(run),
        stop_(stop.in("shape")),
        solver_(group, run, stop_, true,
                [this](std::size_t k, Budget& budget) { return refine_without_overlap(k, budget); }) {}

  /// Solves the group, whose charts must have no flipped triangles.
  void solve() {
    const GroupSolver::Outcome common = solver_.solve();
    for (std::size_t k = 0; k < group_.size(); ++k) {
      if (common.is_solved) {
        finish(k, common.is_folded[k] != 0);
      } else {
        solve_with_fixed_seams(k, common.ran_out);
      }
    }
  }

  /// Solves a chart whose layout without the stretch is flipped or overlaps itself. Returns whether a shape was found.
  /// variation: h of its elastic seams; ran_out: whether a limit ended an earlier attempt.
  bool solve_faulty(std::size_t k, const std::vector<double>& variation, bool ran_out) {
    if (!refine_faulty(k, variation, ran_out)) {
      explain(k, ran_out);
      return false;
    }
    finish(k, has_folds(group_[k].chart.mesh, group_[k].solved.uv));
    return true;
  }

 private:
  /// Minimizes the energy of the stage from the layout `start`, and keeps the rotation of this layout.
  Solution refine(const Stage& stage, std::size_t k, const Positions2& start, Budget& budget) const {
    const Chart& chart = group_[k].chart;
    TargetLengths lengths = group_[k].lengths;
    lengths.grains = {hold_upright(chart, start, run_.options)};
    return refine_coupled({{chart, &lengths, {start}}}, run_.options.fairness, stage, {budget, stop_}).front();
  }

  Stage stage_of_cloth(Injectivity injectivity) const { return {&*run_.options.cloth, nullptr, injectivity}; }

  Solution refine_without_overlap(std::size_t k, Budget& budget) const {
    if (!solver_.was_good(k)) return {};
    const SolvedChart& before = solver_.before(k);
    Solution refined = refine(stage_of_cloth(Injectivity::global), k, before.uv, budget);
    refined.start = before.report.start.c_str();
    refined.iterations += before.report.outer_iterations;
    return refined;
  }

  void solve_with_fixed_seams(std::size_t k, bool ran_out) {
    GroupSolver::Outcome alone;
    if (group_[k].is_nominal) {
      const FixedSeams fixed(group_[k].chart);
      alone = solver_.solve(k);
    }
    ran_out = ran_out || alone.ran_out;
    if (alone.is_solved) {
      finish(k, alone.is_folded.front() != 0);
      report_fixed_seams(group_[k].solved.report);
    } else if (solver_.was_good(k)) {
      explain(k, ran_out);
    } else if (solve_faulty(k, eases_of(group_[k].chart), ran_out) && group_[k].is_nominal) {
      report_fixed_seams(group_[k].solved.report);
    }
  }

  /// Returns a layout with the stretched lengths, in the plane of the stretched fabric; nullopt if no layout is found.
  std::optional<Positions2> start_from_scratch(std::size_t k, Budget& budget) const {
    Chart stretched = group_[k].chart;
    set_stretched_lengths(group_[k], stretched);
    InternalOptions options = run_.options;
    options.cloth.reset();
    options.makes_injective = false;
    Problem problem(stretched, options.fairness);
    Solution found = refine_chart(problem, options, {budget, stop_});
    if (!found.is_exact()) return std::nullopt;
    stand_upright(found.shape.uv, upright_direction(stretched, found.shape.uv, run_.options));
    return found.shape.uv * group_[k].lengths.flat_share.cwiseInverse().asDiagonal();
  }

  /// Finds the shape for solve_faulty(). Returns false if no shape was found. Sets ran_out if the limit of
  /// factorizations ended a solver.
  bool refine_faulty(std::size_t k, const std::vector<double>& variation, bool& ran_out) {
    if (stop_.is_stopped()) return false;
    SolvedChart& one = group_[k].solved;
    const FixedSeams fixed(group_[k].chart, variation);
    Budget budget(run_.options.max_factorizations);
    // The energy of a fabric is infinite for flipped triangles, so the shape error is minimized first.
    Solution found = refine({}, k, solver_.before(k).uv, budget);
    if (!found.is_exact()) {
      if (const std::optional<Positions2> start = start_from_scratch(k, budget)) {
        found = refine({}, k, *start, budget);
      }
    }
    if (found.is_exact() && !has_flips(group_[k].chart.mesh, found.shape.uv)) {
      Solution of_cloth = refine(stage_of_cloth(Injectivity::local), k, found.shape.uv, budget);
      of_cloth.iterations += found.iterations;
      found.status = SolutionStatus::stalled;
      if (of_cloth.is_exact()) found = std::move(of_cloth);
    }
    one.report.factorizations += budget.spent();
    if (!found.is_exact()) {
      ran_out = ran_out || budget.ran_out();
      return false;
    }
    report_next_refinement(found, stop_.is_stopped(), one.report);
    take_shape(found.shape, group_[k]);
    return true;
  }

  void finish(std::size_t k, bool is_folded) {
    const GroupMember& member = group_[k];
    set_stretched_lengths(member, member.chart);
    if (is_folded) propose_seams_for_layout(member.chart, run_, stop_, member.solved);
    make_flat(member);
  }

  /// Replaces the layout with an error. The error proposes seams for the chart with stretched lengths.
  void explain(std::size_t k, bool ran_out) const {
    Chart stretched = group_[k].chart;
    set_stretched_lengths(group_[k], stretched);
    std::vector<VertexPair> seams;
    if (!stop_.is_stopped()) seams = attempt([&] { return seams_for(stretched, run_, stop_); });
    const bool is_good_unstretched = solver_.was_good(k);
    SolvedChart& one = group_[k].solved;
    one.uv.resize(0, 2);
    one.network.reset();
    one.proposed_seams.clear();
    one.report.termination = stop_.is_stopped() ? Termination::cancelled : Termination::failed;
    one.error = stop_.is_stopped() ? cancelled()
                                   : infeasible_stretch(stretched, run_.options, seams, is_good_unstretched, ran_out);
  }

  static void set_stretched_lengths(const GroupMember& member, Chart& chart) {
    const std::vector<double>& ratio = member.lengths.ratio;
    chart.length_ratio.resize(chart.mesh.n_edges(), 1);
    for (std::size_t e = 0; e < ratio.size(); ++e) chart.length_ratio[e] *= ratio[e];
  }

  static void make_flat(const GroupMember& member) {
    const Chart& chart = member.chart;
    const Eigen::RowVector2d& share = member.lengths.flat_share;
    SolvedChart& one = member.solved;
    one.report.objective *= share.prod();  // now a sum over the flat area, not the stretched area
    one.uv = one.uv * share.asDiagonal();
    one.network = build_wire_network(chart);
    const std::vector<double> flat = variations_of(chart, length_variation(chart, one.uv));
    for (std::size_t i = 0; i < flat.size(); ++i) {
      if (chart.wire_parts[i].kind == WireKind::super_elastic) one.variation[i] = flat[i];
    }
  }

  const std::vector<GroupMember>& group_;
  const Run& run_;
  const StopToken stop_;
  GroupSolver solver_;
};

/// Returns h of each wire part of a chart. On elastic seams that other charts share, this is the h of the other charts.
std::vector<double> variation_of_mates(const GroupMember& member, const std::vector<GroupMember>& others) {
  std::vector<double> variation = member.solved.variation;
  for (const GroupMember& other : others) {
    if (other.solved.uv.rows() == 0) continue;
    for (std::size_t i = 0; i < variation.size(); ++i) {
      const WirePart& own = member.chart.wire_parts[i];
      for (std::size_t j = 0; j < other.chart.wire_parts.size(); ++j) {
        const WirePart& mate = other.chart.wire_parts[j];
        const bool is_same_seam = is_elastic_boundary(own) && is_elastic_boundary(mate) &&
                                  mate.wire_index == own.wire_index && mate.part == own.part;
        if (is_same_seam) variation[i] = other.solved.variation[j];
      }
    }
  }
  return variation;
}

/// Solves a coupled group. flipped: charts whose layouts without the stretch are flipped. They use the common lengths
/// of the others.
void stretch_group(const std::vector<GroupMember>& others, const std::vector<GroupMember>& flipped, const Run& run,
                   const StopToken& stop) {
  if (!others.empty()) StretchedGroup(others, run, stop).solve();
  for (const GroupMember& member : flipped) {
    StretchedGroup({member}, run, stop).solve_faulty(0, variation_of_mates(member, others), false);
  }
}

}  // namespace

void stretch_charts(Charts& charts, const Run& run, ProgressReport& report, std::vector<SolvedChart>& solved) {
  const Cloth& cloth = *run.options.cloth;
  ChartsProgress progress(report, charts.charts, kUnstretched, kChartsFlat);
  const StretchedLengths lengths = find_stretched_lengths(charts, solved, cloth);
  const std::vector<std::vector<int>> groups = group_by_elastic_seams(charts.charts);
  progress.run(groups.size(), [&](std::size_t g) {
    const std::vector<int>& group = groups[g];
    const bool is_elastic = std::any_of(group.begin(), group.end(), [&](int c) {
      const std::vector<WirePart>& parts = charts.charts[c].wire_parts;
      return std::any_of(parts.begin(), parts.end(), is_elastic_boundary);
    });
    std::vector<GroupMember> flipped, others;
    for (const int c : group) {
      Chart& chart = charts.charts[c];
      const Positions2& uv = solved[c].uv;
      if (uv.rows() == 0) continue;
      const bool is_flipped = has_flips(chart.mesh, uv);
      (is_flipped ? flipped : others)
          .push_back({chart,
                      solved[c],
                      is_elastic,
                      {{hold_upright(chart, uv, run.options)}, lengths.ratios[c], flat_share(cloth)}});
    }
    stretch_group(others, flipped, run, progress.stop_token(static_cast<std::size_t>(group.front())));
    for (const int c : group) progress.finish(static_cast<std::size_t>(c));
  });
  for (std::size_t c = 0; c < solved.size(); ++c) {
    std::vector<std::string>& own = solved[c].report.warnings;
    own.insert(own.end(), lengths.warnings[c].begin(), lengths.warnings[c].end());
  }
}

}  // namespace wirewarp
