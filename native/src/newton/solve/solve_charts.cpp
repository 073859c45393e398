// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/solve/solve_charts.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

#include "base/in_threads.h"
#include "newton/refine_chart.h"
#include "newton/refine_cloth.h"
#include "newton/solve/charts_progress.h"
#include "newton/solve/group_solver.h"
#include "newton/solve/piece_report.h"
#include "newton/solve/stretched_lengths.h"
#include "surface/charts/elastic_seams.h"
#include "surface/charts/folded_faces.h"

namespace wirewarp {
namespace {

/// The largest charts come first, so that no core waits long for the last chart.
std::vector<std::size_t> largest_first(const std::vector<Chart>& charts) {
  std::vector<std::size_t> order(charts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return charts[a].source_face.size() > charts[b].source_face.size();
  });
  return order;
}

/// Returns options for shapes that later stages refine. Orientation::best needs the exact minimum immediately, because
/// later stages keep the direction that it finds.
InternalOptions on_the_way(InternalOptions options) {
  if (options.orientation != Orientation::best) options.target = options.cloth ? Target::rough : Target::newton_step;
  return options;
}

/// Frees the elastic seams of a group. If no common lengths are found, solves each chart alone with these seams fixed
/// at h = ease. A chart without a shape then gets an error.
void free_elastic_seams(const std::vector<GroupMember>& group, const Run& run, const StopToken& stop) {
  const StopToken in_shape = stop.in("shape");
  GroupSolver solver(group, run, in_shape, false, [&](std::size_t k, Budget& budget) {
    Problem problem(group[k].chart, run.options.fairness);
    return refine_chart(problem, run.options, {budget, in_shape});
  });
  const GroupSolver::Outcome common = solver.solve();
  for (std::size_t k = 0; k < group.size(); ++k) {
    const GroupMember& member = group[k];
    if (common.is_solved) {
      if (common.is_folded[k] != 0) propose_seams_for_layout(member.chart, run, in_shape, member.solved);
      continue;
    }
    const FixedSeams fixed(member.chart);
    SolvedChart& solved = member.solved;
    if (!member.is_nominal) {  // no shape was found at h = ease, so find the error
      Budget budget(run.options.max_factorizations);
      budget.spend(solved.report.factorizations);
      solved = in_shape.is_stopped() ? cancelled_chart() : solve_chart(member.chart, run, budget, in_shape);
      solved.report.factorizations = budget.spent();
      if (!solved.error) report_fixed_seams(solved.report);
      continue;
    }
    if (!solver.solve(k).is_solved && in_shape.is_stopped()) {
      report_cancelled(solved.report);
      continue;
    }
    if (has_folds(member.chart.mesh, solved.uv)) propose_seams_for_layout(member.chart, run, in_shape, solved);
    report_fixed_seams(solved.report);
  }
}

/// Several charts with common elastic seams, for the refined method.
struct Group {
  std::vector<int> charts;
  bool is_known = false;  // whether its solutions came from the cache
};

class ChartsSolver {
 public:
  ChartsSolver(std::vector<Chart>& charts, const Run& run, ProgressReport& report, CacheSession& session)
      : charts_(charts),
        run_(run),
        report_(report),
        session_(session),
        progress_(report, charts, kChartsCut, is_stretched(run.options) ? kUnstretched : kChartsFlat),
        solved_(charts.size()),
        group_of_chart_(charts.size(), nullptr),
        is_nominal_(charts.size(), 0) {
    if (run.options.method != Method::refined) return;
    for (std::vector<int>& group : group_by_elastic_seams(charts)) {
      if (group.size() > 1) groups_.push_back({std::move(group)});
    }
    for (const Group& group : groups_) {
      for (const int c : group.charts) group_of_chart_[c] = &group;
    }
  }

  std::vector<SolvedChart> solve() {
    for (Group& group : groups_) recall(group);
    const std::vector<std::size_t> order = largest_first(charts_);
    progress_.run(charts_.size(), [&](std::size_t i) { solve_one(order[i]); });
    progress_.run(groups_.size(), [&](std::size_t g) { couple(groups_[g]); });
    return std::move(solved_);
  }

 private:
  std::vector<const Chart*> members(const Group& group) const {
    std::vector<const Chart*> members;
    for (const int c : group.charts) members.push_back(&charts_[c]);
    return members;
  }

  void recall(Group& group) {
    std::optional<std::vector<SolvedChart>> known = session_.known(members(group));
    group.is_known = known.has_value();
    for (std::size_t k = 0; known && k < known->size(); ++k) solved_[group.charts[k]] = std::move((*known)[k]);
  }

  void solve_one(std::size_t c) {
    std::optional<OnOneCore> on_one_core;
    if (progress_.is_one_of_many(c)) on_one_core.emplace();
    const Chart& chart = charts_[c];
    const Group* group = group_of_chart_[c];
    if (chart.mesh.n_faces() == 0 || (chart.error && report_.is_cancelled())) {
      solved_[c].error = chart.error;
    } else if (!group) {
      solve_alone(c);
    } else if (!group->is_known) {
      begin_beside_elastic_seams(c);
      return;  // couple() continues
    }
    progress_.finish(c);
  }

  void solve_alone(std::size_t c) {
    if (std::optional<std::vector<SolvedChart>> known = session_.known({&charts_[c]})) {
      solved_[c] = std::move(known->front());
      return;
    }
    Budget budget(run_.options.max_factorizations);
    const StopToken stop = progress_.stop_token(c);
    solved_[c] = report_.is_cancelled() ? cancelled_chart() : solve_chart(charts_[c], run_, budget, stop);
    complete(c);
    session_.keep({&charts_[c]}, {&solved_[c]});
  }

  /// Solves a chart with its elastic seams at h = ease. If no shape is found, solves it with the best lengths of these
  /// seams for this chart alone.
  void begin_beside_elastic_seams(std::size_t c) {
    if (report_.is_cancelled()) {
      solved_[c] = cancelled_chart();
      return;
    }
    const InternalOptions options = on_the_way(run_.options);
    const StopToken stop = progress_.stop_token(c);
    Budget budget(options.max_factorizations);
    {
      const FixedSeams fixed(charts_[c]);
      solved_[c] = solve_chart(charts_[c], {run_.input, options, {}}, budget, stop);
    }
    is_nominal_[c] = solved_[c].error ? 0 : 1;
    if (!solved_[c].error || stop.is_stopped()) return;
    solved_[c] = solve_chart(charts_[c], {run_.input, options, run_.propose_seams}, budget, stop);
    solved_[c].report.factorizations = budget.spent();  // counted even if there is an error
  }

  void couple(const Group& group) {
    if (group.is_known) return;
    std::vector<GroupMember> begun;
    for (const int c : group.charts) {
      if (solved_[c].uv.rows() > 0)
        begun.push_back({charts_[c], solved_[c], is_nominal_[c] != 0, lengths_of(charts_[c], solved_[c].uv)});
    }
    const auto first = static_cast<std::size_t>(group.charts.front());
    if (!begun.empty()) free_elastic_seams(begun, run_, progress_.stop_token(first));
    std::vector<const SolvedChart*> solved;
    for (const int c : group.charts) {
      complete(static_cast<std::size_t>(c));
      solved.push_back(&solved_[c]);
      progress_.finish(static_cast<std::size_t>(c));
    }
    session_.keep(members(group), solved);
  }

  /// If a chart has a layout, builds its wire network for the result. Drops the multipliers, which no later stage uses.
  void complete(std::size_t c) {
    solved_[c].multipliers.resize(0);
    if (solved_[c].uv.rows() > 0) solved_[c].network = build_wire_network(charts_[c]);
  }

  TargetLengths lengths_of(const Chart& chart, const Positions2& uv) const {
    return run_.options.cloth ? TargetLengths{{hold_upright(chart, uv, run_.options)}, {}} : TargetLengths{};
  }

  std::vector<Chart>& charts_;
  const Run& run_;
  ProgressReport& report_;
  CacheSession& session_;
  ChartsProgress progress_;
  std::vector<Group> groups_;
  std::vector<SolvedChart> solved_;
  std::vector<const Group*> group_of_chart_;  // null: the chart shares no elastic seams
  std::vector<char> is_nominal_;              // whether the chart was solved with h = ease
};

}  // namespace

std::vector<SolvedChart> solve_charts(std::vector<Chart>& charts, const Run& run, ProgressReport& report,
                                      CacheSession& session) {
  return ChartsSolver(charts, run, report, session).solve();
}

}  // namespace wirewarp
