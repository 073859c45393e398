// SPDX-License-Identifier: GPL-3.0-or-later
// The pipeline from the input to the result. The mathematics is in the included files. native/README.md lists the file
// for each part of the paper.
#include "flatten.h"

#include <stdexcept>
#include <utility>

#include "base/progress_report.h"
#include "cuts/feasibility/open_chart.h"
#include "newton/cache/cache_session.h"
#include "newton/refine_chart.h"
#include "newton/solve/chart_errors.h"
#include "newton/solve/piece_report.h"
#include "newton/solve/solve_charts.h"
#include "newton/solve/stretch_charts.h"
#include "newton/solve/stretched_lengths.h"
#include "result/assemble_result.h"
#include "result/pack_pieces.h"
#include "surface/charts/cut_into_charts.h"
#include "surface/check_input/check_input.h"
#include "surface/middle_surface.h"

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

/// Seconds of a run, per stage.
using Seconds = std::map<std::string, double>;

Charts cut(const Run& run, const EdgeTable& edges, ProgressReport& report, Seconds& seconds) {
  const StageTimer timer(seconds, "charts");
  const StopToken stop([&](const char* stage) { return report.go_on(stage, 0); });
  return cut_into_charts(run.input, edges, stop.in("charts"));
}

/// After the caller cancels, flat pieces are still measured until a WorkMeter has polled this many times, which takes
/// about half a second at most.
constexpr int kQuestionsAfterCancel = 25;

StopToken while_measuring(ProgressReport& report) {
  const bool was_cancelled = report.is_cancelled();
  if (!was_cancelled) report.go_on("measure", kChartsFlat);
  const StopToken stop([&report, was_cancelled, left = kQuestionsAfterCancel](const char* stage) mutable {
    return was_cancelled ? left-- > 0 : report.go_on(stage, kChartsFlat);
  });
  return stop.in("measure");
}

void pack(const Charts& charts, const Options& options, const StopToken& stop, std::vector<SolvedChart>& solved_charts,
          Seconds& seconds) {
  const StageTimer timer(seconds, "packing");
  std::vector<Positions2> shapes;
  for (SolvedChart& solved : solved_charts) shapes.push_back(std::move(solved.uv));
  shapes = pack_pieces(charts.charts, std::move(shapes), options, stop);
  for (std::size_t c = 0; c < solved_charts.size(); ++c) solved_charts[c].uv = std::move(shapes[c]);
}

/// Flattens charts after they were cut. Throws Stopped if the caller canceled and much remains to be measured.
FlattenResult flatten_cut(Charts charts, const Run& run, ProgressReport& report, Cache* cache, Seconds& seconds) {
  CacheSession session(cache, run.input, run.options);
  std::vector<SolvedChart> solved_charts = solve_charts(charts.charts, run, report, session);
  session.finish();
  if (is_stretched(run.options)) stretch_charts(charts, run, report, solved_charts);
  const StopToken stop = while_measuring(report);
  pack(charts, run.options, stop, solved_charts, seconds);
  const StageTimer timer(seconds, "measure");
  FlattenResult result = assemble_result(run.input, charts, std::move(solved_charts), run.options, stop);
  result.reused_pieces = session.num_reused();
  return result;
}

/// Returns the result of a run that was stopped before its charts were solved or while they were measured. No piece has
/// a layout.
FlattenResult cancelled_result(const FlattenInput& input, const EdgeTable& edges) {
  const Charts charts = list_charts(input, edges, cancelled());
  return assemble_result(input, charts, std::vector<SolvedChart>(charts.charts.size(), cancelled_chart()), {});
}

Run run_of(const FlattenInput& input, const InternalOptions& options) {
  Run run{input, options, {}};
  if (!options.with_proposals) return run;
  run.propose_seams = [&options](const Chart& chart, const StopToken& stop) {
    const auto lies_flat_alone = [&](const Chart& part) { return lies_flat(part, options, stop); };
    const CutMask cut = open_chart(chart, lies_flat_alone, stop.in("shape"));
    if (stop.is_stopped()) throw Stopped();
    return edges_of(chart, cut);
  };
  return run;
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

FlattenResult flatten_charts(Charts charts, const FlattenInput& input, const InternalOptions& options,
                             const StopToken& stop) {
  const Progress progress = [&](const std::string&, double) { return stop.may_go_on(); };
  ProgressReport report(progress);
  Seconds seconds;
  FlattenResult result = flatten_cut(std::move(charts), run_of(input, options), report, nullptr, seconds);
  stop.check();
  return result;
}

FlattenResult flatten_with(const FlattenInput& input, const InternalOptions& options, const Progress& progress,
                           Cache* cache) {
  Seconds seconds;
  FlattenResult result;
  {
    const StageTimer total(seconds, "total");
    ProgressReport report(progress);
    const EdgeTable edges = check_request(input, options);
    try {
      std::optional<FlattenInput> middle;
      if (options.thickness > 0) middle = move_to_middle(input, options);
      const Run run = run_of(middle ? *middle : input, options);
      result = flatten_cut(cut(run, edges, report, seconds), run, report, cache, seconds);
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
