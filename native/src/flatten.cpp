// SPDX-License-Identifier: GPL-3.0-or-later
// The pipeline, top-down; the mathematics is in the files it names. native/README.md maps the paper to them.
#include "wirewarp/flatten.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "cache/cache_session.h"
#include "chart_errors.h"
#include "charts/cut_into_charts.h"
#include "charts/seams_that_give.h"
#include "charts_progress.h"
#include "check_input/check_input.h"
#include "internal_options.h"
#include "join_charts.h"
#include "metrics/assemble_result.h"
#include "middle_surface.h"
#include "packing/pack_pieces.h"
#include "piece_report.h"
#include "progress_report.h"
#include "refine/refine_cloth.h"
#include "solve_chart.h"
#include "stop_token.h"
#include "stretch_charts.h"

namespace wirewarp {
namespace {

const char* name_of(Method method) {
  switch (method) {
    case Method::wirewarping:
      return "wirewarping";
    case Method::wirewarp_plus_plus:
      return "wirewarp++";
    case Method::refined:
      return "refined";
  }
  throw std::logic_error("not a Method");
}

/// The largest first, so that no core waits long for the last.
std::vector<std::size_t> largest_first(const std::vector<Chart>& charts) {
  std::vector<std::size_t> order(charts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return charts[a].source_face.size() > charts[b].source_face.size();
  });
  return order;
}

bool is_stretched(const Options& options) {
  return options.cloth && options.cloth->stretch != std::array<double, 2>{0, 0};
}

// How much of a run is done once charts are cut, once each is flat but for the cloth's stretch, once all are. The
// stretch begins near its end.
constexpr double kCut = 0.2, kLoose = 0.7, kFlat = 0.9;

/// Options for shapes that others begin at. The best direction of a cloth stays, so it has to be exact.
InternalOptions on_the_way(InternalOptions options) {
  if (options.orientation != Orientation::best) options.aim = options.cloth ? Aim::rough : Aim::newton_step;
  return options;
}

/// All charts, on all cores; each has the layout that it has alone, those beside seams that give the one that they have
/// together.
class ChartsSolver {
 public:
  ChartsSolver(const std::vector<Chart>& charts, const Run& run, ProgressReport& report, CacheSession& session)
      : charts_(charts),
        run_(run),
        report_(report),
        session_(session),
        progress_(report, charts, kCut, is_stretched(run.options) ? kLoose : kFlat),
        solved_(charts.size()),
        is_done_(charts.size(), 0),
        is_together_(charts.size(), 0),
        is_settled_(charts.size(), 0) {
    if (run.options.method != Method::refined) return;
    for (std::vector<int>& group : group_by_seams_that_give(charts)) {
      if (group.size() > 1) groups_.push_back(std::move(group));
    }
  }

  std::vector<SolvedChart> solve() {
    for (const std::vector<int>& group : groups_) recall(group);
    const std::vector<std::size_t> order = largest_first(charts_);
    progress_.run(charts_.size(), [&](std::size_t i) { solve_one(order[i]); });
    progress_.run(groups_.size(), [&](std::size_t g) { join(groups_[g]); });
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
    for (const int c : group) is_together_[c] = 1;
    std::optional<std::vector<SolvedChart>> known = session_.known(members(group));
    if (!known) return;
    for (std::size_t k = 0; k < group.size(); ++k) {
      solved_[group[k]] = std::move((*known)[k]);
      is_done_[group[k]] = 1;
    }
  }

  void solve_one(std::size_t c) {
    std::optional<OnOneCore> on_one_core;
    if (progress_.is_one_of_many(c)) on_one_core.emplace();
    const Chart& chart = charts_[c];
    if (chart.mesh.n_faces() == 0 || (chart.error && report_.is_cancelled())) {
      solved_[c].error = chart.error;
    } else if (is_together_[c] == 0) {
      solve_alone(c);
    } else if (is_done_[c] == 0) {
      begin_beside_seams_that_give(c);
      return;  // join() goes on with it
    }
    progress_.finish(c);
  }

  /// With these at h = ease; where the chart has no shape so, each as long as it would have it alone.
  void begin_beside_seams_that_give(std::size_t c) {
    if (report_.is_cancelled()) {
      solved_[c] = cancelled_chart();
      return;
    }
    const InternalOptions options = on_the_way(run_.options);
    InternalOptions trial = options;
    trial.with_proposals = false;  // nobody is told of its errors
    const StopToken stop = stop_token(c);
    solved_[c] = solve_settled(charts_[c], {run_.input, trial}, stop);
    is_settled_[c] = solved_[c].error ? 0 : 1;
    if (solved_[c].error && !stop.is_stopped()) solved_[c] = solve_chart(charts_[c], {run_.input, options}, stop);
  }

  void solve_alone(std::size_t c) {
    if (std::optional<std::vector<SolvedChart>> known = session_.known({&charts_[c]})) {
      solved_[c] = std::move(known->front());
      return;
    }
    solved_[c] = report_.is_cancelled() ? cancelled_chart() : solve_chart(charts_[c], run_, stop_token(c));
    solved_[c].multipliers.resize(0);
    session_.keep({&charts_[c]}, {&solved_[c]});
  }

  void join(const std::vector<int>& group) {
    if (is_done_[group.front()] != 0) return;  // from the cache
    std::vector<ChartToJoin> to_join;
    for (const int c : group) {
      if (solved_[c].uv.rows() == 0) continue;
      to_join.push_back({charts_[c], solved_[c], is_settled_[c] != 0, cloth_on(c)});
    }
    if (!to_join.empty()) {
      const auto from_scratch = [&](std::size_t, const Chart& settled, const StopToken& stop) {
        return refine_unfolded(settled, run_.options, stop);
      };
      const JoinOutcome outcome =
          join_charts(to_join, run_.options, from_scratch, stop_token(static_cast<std::size_t>(group.front())));
      to_join.front().solved.report.factorizations += outcome.factorizations;
      std::size_t next = 0;  // of those to join
      for (const int c : group) {
        if (solved_[c].uv.rows() == 0) continue;
        finish_joined(static_cast<std::size_t>(c), outcome.is_joined, !outcome.is_joined || outcome.is_folded[next++]);
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

  /// Without common lengths a chart has those at h = ease, or the error that it has so.
  void finish_joined(std::size_t c, bool is_joined, bool is_folded) {
    SolvedChart& solved = solved_[c];
    solved.multipliers.resize(0);
    if (is_joined) {
      if (is_folded) propose_seams_for(c);
    } else if (!report_.is_cancelled()) {
      finish_settled(c);
    } else if (is_settled_[c] == 0) {
      solved = cancelled_chart();
    } else if (solved.report.termination != Termination::cancelled) {
      report_cancelled(solved.report);
    }
  }

  void propose_seams_for(std::size_t c) {
    SolvedChart& solved = solved_[c];
    if (report_.is_cancelled()) return;
    try {
      solved.proposed_seams = propose_seams(charts_[c], run_, stop_token(c));
    } catch (const Stopped&) {
      report_cancelled(solved.report);
    }
  }

  void finish_settled(std::size_t c) {
    SolvedChart& solved = solved_[c];
    const int spent = solved.report.factorizations;
    solved = solve_settled(charts_[c], run_, stop_token(c));
    solved.multipliers.resize(0);
    solved.report.factorizations += spent;
    if (solved.error || solved.report.termination == Termination::cancelled) return;
    report_settled(solved.report);
  }

  const std::vector<Chart>& charts_;
  const Run& run_;
  ProgressReport& report_;
  CacheSession& session_;
  ChartsProgress progress_;
  std::vector<std::vector<int>> groups_;  // of several charts
  std::vector<SolvedChart> solved_;
  std::vector<char> is_done_;      // taken from the cache with its group
  std::vector<char> is_together_;  // in a group
  std::vector<char> is_settled_;   // begins with the seams that give at h = ease
};

void pack(const Charts& charts, const Options& options, const StopToken& stop,
          std::vector<SolvedChart>& solved_charts) {
  std::vector<Positions2> shapes;
  for (SolvedChart& solved : solved_charts) shapes.push_back(std::move(solved.uv));
  shapes = pack_pieces(charts.charts, std::move(shapes), options, stop);
  for (std::size_t c = 0; c < solved_charts.size(); ++c) solved_charts[c].uv = std::move(shapes[c]);
}

/// Of a run that was stopped before or after all charts: no piece has a layout.
FlattenResult cancelled_result(const FlattenInput& input, const EdgeTable& edges) {
  const Charts charts = list_charts(input, edges, cancelled());
  return assemble_result(input, charts, std::vector<SolvedChart>(charts.charts.size(), cancelled_chart()), {});
}

/// Pieces that are flat when the caller cancels are measured if that takes no more questions than these of a WorkMeter:
/// half a second at most.
constexpr int kQuestionsAfterCancel = 25;

/// What flatten() makes of charts once they are cut. Throws Stopped where the caller cancels while much remains to be
/// measured.
FlattenResult flatten_cut(Charts charts, const Run& run, ProgressReport& report, Cache* cache,
                          std::map<std::string, double>& seconds) {
  CacheSession session(cache, run.input, run.options);
  std::vector<SolvedChart> solved_charts = ChartsSolver(charts.charts, run, report, session).solve();
  session.finish();
  if (is_stretched(run.options)) {
    ChartsProgress progress(report, charts.charts, kLoose, kFlat);
    stretch_charts(charts, run, progress, solved_charts);
  }
  const bool was_cancelled = report.is_cancelled();
  if (!was_cancelled) report.go_on("measure", 0.9);
  int questions_left = was_cancelled ? kQuestionsAfterCancel : 0;
  const StopToken may_measure(
      [&](const char* stage) { return was_cancelled ? questions_left-- > 0 : report.go_on(stage, 0.9); });
  const StopToken stop = may_measure.in("measure");
  {
    const StageTimer timer(seconds, "packing");
    pack(charts, run.options, stop, solved_charts);
  }
  const StageTimer timer(seconds, "measure");
  FlattenResult result = assemble_result(run.input, charts, std::move(solved_charts), run.options, stop);
  result.reused_pieces = session.num_reused();
  return result;
}

Charts cut_with_progress(const Run& run, const EdgeTable& edges, ProgressReport& report,
                         std::map<std::string, double>& seconds) {
  const StageTimer timer(seconds, "charts");
  const StopToken stop([&](const char* stage) { return report.go_on(stage, 0); });
  return cut_into_charts(run.input, edges, stop.in("charts"));
}

}  // namespace

FlattenResult flatten(const FlattenInput& input, const Options& options, const Progress& progress, Cache* cache) {
  return flatten_with(input, options, progress, cache);
}

EdgeTable check_request(const FlattenInput& input, const Options& options) {
  check_options(options, input.wires.size());
  check_mesh(input);
  EdgeTable edges(input.faces, static_cast<int>(input.vertices.rows()));
  check_faces_share_edges(input, edges);
  check_seams_and_wires(input, edges);
  return edges;
}

FlattenResult flatten_charts(Charts charts, const Run& run, const StopToken& stop) {
  const Progress progress = [&](const std::string&, double) { return stop.may_go_on(); };
  ProgressReport report(progress);
  std::map<std::string, double> seconds;
  FlattenResult result = flatten_cut(std::move(charts), run, report, nullptr, seconds);
  stop.check();
  return result;
}

FlattenResult flatten_with(const FlattenInput& input, const InternalOptions& options, const Progress& progress,
                           Cache* cache) {
  std::map<std::string, double> seconds;
  FlattenResult result;
  {
    const StageTimer total(seconds, "total");
    ProgressReport report(progress);

    const EdgeTable edges = check_request(input, options);
    try {
      std::optional<FlattenInput> middle;
      if (options.thickness > 0) middle = move_to_middle(input, options);
      const Run run{middle ? *middle : input, options};
      result = flatten_cut(cut_with_progress(run, edges, report, seconds), run, report, cache, seconds);
    } catch (const Stopped&) {
      result = cancelled_result(input, edges);
    }
    report.go_on("measure", 1);
  }
  for (const Piece& piece : result.pieces) {
    for (const auto& [stage, time] : piece.report.seconds) seconds[stage] += time;
  }
  result.seconds = std::move(seconds);
  result.method = name_of(options.method);
  return result;
}

}  // namespace wirewarp
