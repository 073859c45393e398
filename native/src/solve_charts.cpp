// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve_charts.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

#include "charts/elastic_seams.h"
#include "couple_charts.h"
#include "feasibility/folded_faces.h"
#include "in_threads.h"
#include "piece_report.h"
#include "refine/refine_cloth.h"

namespace wirewarp {
namespace {

/// The largest first, so that no core waits long for the last.
std::vector<std::size_t> largest_first(const std::vector<Chart>& charts) {
  std::vector<std::size_t> order(charts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return charts[a].source_face.size() > charts[b].source_face.size();
  });
  return order;
}

/// Options for shapes that others begin at. The best direction of a cloth stays, so it has to be exact.
InternalOptions on_the_way(InternalOptions options) {
  if (options.orientation != Orientation::best) options.aim = options.cloth ? Aim::rough : Aim::newton_step;
  return options;
}

/// Where a chart is. Those of a coupled group begin, each by itself, then are solved together.
enum class Stage {
  uncoupled,  // has no elastic seam in common with another chart
  waiting,    // of a coupled group
  nominal,    // begun with its elastic seams at h = ease
  elastic,    // has no shape so: begun with each of these seams as long as it would be for this chart alone
  known,      // with its group, from the cache
};

class ChartsSolver {
 public:
  ChartsSolver(const std::vector<Chart>& charts, const Run& run, ProgressReport& report, ChartsProgress& progress,
               CacheSession& session)
      : charts_(charts),
        run_(run),
        report_(report),
        session_(session),
        progress_(progress),
        solved_(charts.size()),
        stage_(charts.size(), Stage::uncoupled) {
    if (run.options.method != Method::refined) return;
    for (std::vector<int>& group : group_by_elastic_seams(charts)) {
      if (group.size() > 1) groups_.push_back(std::move(group));
    }
  }

  std::vector<SolvedChart> solve() {
    for (const std::vector<int>& group : groups_) recall(group);
    const std::vector<std::size_t> order = largest_first(charts_);
    progress_.run(charts_.size(), [&](std::size_t i) { solve_one(order[i]); });
    progress_.run(groups_.size(), [&](std::size_t g) { couple(groups_[g]); });
    return std::move(solved_);
  }

 private:
  StopToken stop_token(std::size_t c) { return progress_.stop_token(c); }

  std::vector<const Chart*> members(const std::vector<int>& group) const {
    std::vector<const Chart*> members;
    for (const int c : group) members.push_back(&charts_[c]);
    return members;
  }

  void recall(const std::vector<int>& group) {
    for (const int c : group) stage_[c] = Stage::waiting;
    std::optional<std::vector<SolvedChart>> known = session_.known(members(group));
    if (!known) return;
    for (std::size_t k = 0; k < group.size(); ++k) {
      solved_[group[k]] = std::move((*known)[k]);
      stage_[group[k]] = Stage::known;
    }
  }

  void solve_one(std::size_t c) {
    std::optional<OnOneCore> on_one_core;
    if (progress_.is_one_of_many(c)) on_one_core.emplace();
    const Chart& chart = charts_[c];
    if (chart.mesh.n_faces() == 0 || (chart.error && report_.is_cancelled())) {
      solved_[c].error = chart.error;
    } else if (stage_[c] == Stage::uncoupled) {
      solve_alone(c);
    } else if (stage_[c] == Stage::waiting) {
      begin_beside_elastic_seams(c);
      return;  // couple() goes on with it
    }
    progress_.finish(c);
  }

  /// With these seams at h = ease; if the chart has no shape so, each as long as it would be for this chart alone.
  void begin_beside_elastic_seams(std::size_t c) {
    if (report_.is_cancelled()) {
      solved_[c] = cancelled_chart();
      return;
    }
    const InternalOptions options = on_the_way(run_.options);
    InternalOptions trial = options;
    trial.with_proposals = false;  // its errors are not reported
    const StopToken stop = stop_token(c);
    RefineBudget budget(options.max_factorizations);
    solved_[c] = solve_with_fixed_seams(charts_[c], {run_.input, trial}, budget, stop);
    stage_[c] = solved_[c].error ? Stage::elastic : Stage::nominal;
    if (stage_[c] == Stage::nominal || stop.is_stopped()) return;
    solved_[c] = solve_chart(charts_[c], {run_.input, options}, budget, stop);
    solved_[c].report.factorizations = budget.spent();  // also if an error came before any of its own
  }

  RefineAlone from_scratch() const {
    return [&](std::size_t, const Chart& fixed, RefineBudget& budget, const StopToken& stop) {
      return refine_injective(fixed, run_.options, budget, stop);
    };
  }

  void solve_alone(std::size_t c) {
    if (std::optional<std::vector<SolvedChart>> known = session_.known({&charts_[c]})) {
      solved_[c] = std::move(known->front());
      return;
    }
    RefineBudget budget(run_.options.max_factorizations);
    solved_[c] = report_.is_cancelled() ? cancelled_chart() : solve_chart(charts_[c], run_, budget, stop_token(c));
    solved_[c].multipliers.resize(0);
    session_.keep({&charts_[c]}, {&solved_[c]});
  }

  void couple(const std::vector<int>& group) {
    if (stage_[group.front()] == Stage::known) return;
    std::vector<int> begun;
    std::vector<CoupledChart> coupled;
    for (const int c : group) {
      if (solved_[c].uv.rows() == 0) continue;
      begun.push_back(c);
      coupled.push_back(
          {charts_[c], solved_[c], stage_[c] == Stage::nominal, cloth_on(c), run_.options.max_factorizations});
    }
    if (!begun.empty()) {
      const CouplingOutcome outcome =
          couple_charts(coupled, run_.options, from_scratch(), stop_token(static_cast<std::size_t>(group.front())));
      for (std::size_t k = 0; k < begun.size(); ++k) {
        finish_coupled(static_cast<std::size_t>(begun[k]), outcome.is_coupled,
                       outcome.is_coupled && outcome.is_folded[k]);
      }
    }
    std::vector<const SolvedChart*> solved;
    for (const int c : group) solved.push_back(&solved_[c]);
    session_.keep(members(group), solved);
    for (const int c : group) progress_.finish(static_cast<std::size_t>(c));
  }

  /// As it is turned, without its stretch.
  std::optional<ClothOnChart> cloth_on(int c) const {
    if (!run_.options.cloth) return std::nullopt;
    return ClothOnChart{
        without_stretch(*run_.options.cloth), {hold_upright(charts_[c], solved_[c].uv, run_.options)}, {}};
  }

  /// Without common lengths, a chart keeps those at h = ease, or gets the error that it has so.
  void finish_coupled(std::size_t c, bool is_coupled, bool is_folded) {
    SolvedChart& solved = solved_[c];
    if (is_coupled) {
      if (is_folded) propose_seams_for_layout(charts_[c], run_, stop_token(c), solved);
    } else if (!report_.is_cancelled()) {
      finish_with_fixed_seams(c);
    } else if (stage_[c] != Stage::nominal) {
      solved = cancelled_chart();
    } else if (solved.report.termination != Termination::cancelled) {
      report_cancelled(solved.report);
    }
    solved.multipliers.resize(0);
  }

  /// From the shape at hand, if that has its seams at h = ease; else from scratch. That shape stays if the
  /// factorizations are spent.
  void finish_with_fixed_seams(std::size_t c) {
    SolvedChart& solved = solved_[c];
    const StopToken stop = stop_token(c);
    const Chart fixed = with_fixed_seams(charts_[c]);
    CouplingOutcome outcome{false, false, {}};
    if (stage_[c] == Stage::nominal) {
      const std::vector<CoupledChart> alone{
          {fixed, solved, false, cloth_on(static_cast<int>(c)), run_.options.max_factorizations}};
      outcome = couple_charts(alone, run_.options, from_scratch(), stop);
    }
    const bool stays = !outcome.is_coupled && outcome.ran_out;  // from scratch, too little is left for any shape
    if (!outcome.is_coupled && !stays) {
      RefineBudget budget(run_.options.max_factorizations);
      budget.spend(solved.report.factorizations);
      solved = solve_with_fixed_seams(charts_[c], run_, budget, stop);
      solved.report.factorizations = budget.spent();
    } else if (stays ? !find_folded_faces(fixed.mesh, solved.uv).empty() : outcome.is_folded.front() != 0) {
      propose_seams_for_layout(fixed, run_, stop, solved);
    }
    if (solved.error || solved.report.termination == Termination::cancelled) return;
    report_fixed_seams(solved.report);
  }

  const std::vector<Chart>& charts_;
  const Run& run_;
  ProgressReport& report_;
  CacheSession& session_;
  ChartsProgress& progress_;
  std::vector<std::vector<int>> groups_;  // of several charts
  std::vector<SolvedChart> solved_;
  std::vector<Stage> stage_;
};

}  // namespace

std::vector<SolvedChart> solve_charts(const std::vector<Chart>& charts, const Run& run, ProgressReport& report,
                                      ChartsProgress& progress, CacheSession& session) {
  return ChartsSolver(charts, run, report, progress, session).solve();
}

}  // namespace wirewarp
