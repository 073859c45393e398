// SPDX-License-Identifier: GPL-3.0-or-later
// The pipeline, top-down; the mathematics is in the files it names. native/README.md maps the paper to them.
#include "wirewarp/flatten.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "chart_errors.h"
#include "charts/cut_into_charts.h"
#include "check_input/check_input.h"
#include "feasibility/check_outline.h"
#include "feasibility/propose_seams.h"
#include "metrics/assemble_result.h"
#include "metrics/helper_wires.h"
#include "outer/choose_variation.h"
#include "packing/pack_pieces.h"
#include "progress_report.h"
#include "refine/infeasible_wires.h"
#include "reuse/reuse.h"
#include "topology/process_topology.h"

namespace wirewarp {
namespace {

void begin_stage(const GoOn& go_on, const char* stage) {
  if (!go_on(stage)) throw cancelled();
}

void report_solution(const OuterSolution& solution, PieceReport& report) {
  report.inner_solves = solution.inner_solves;
  report.outer_iterations = solution.iterations;
  report.gradient_evaluations = solution.evaluations;
  report.factorizations += solution.free_factorizations;
  report.constraint_residual = solution.shape.inner.closure_residual;
  report.projected_gradient = solution.shape.inner.projected_gradient;
  if (!solution.shape.inner.is_minimum) report.warnings.push_back("The wire angles stopped short of their minimum.");
  if (!solution.converged) report.warnings.push_back("The wire lengths stopped short of the least distortion.");
  report.termination = report.warnings.empty() ? Termination::converged : Termination::stalled;
}

/// Why lengths that were not reached cannot be kept. refined: of the chart, not exact.
FlattenError explain_infeasible(const Chart& chart, const FlattenInput& input, const Options& options,
                                const ChartRefinement& refined, const std::function<bool()>& go_on) {
  if (refined.was_stopped) return cancelled();
  std::vector<ProposedTolerance> tolerances = propose_tolerances(chart, options, refined, go_on);
  if (!go_on()) return cancelled();
  const bool ran_out = refined.shape.factorizations >= options.max_factorizations;
  return infeasible_wires(chart, input.wires, options, std::move(tolerances), ran_out);
}

/// WireWarping and WireWarping++: the wires first, the surface follows (II).
void flatten_by_warping(const Chart& chart, const FlattenInput& input, const Options& options, const GoOn& go_on,
                        Layout& layout) {
  std::map<std::string, double>& seconds = layout.report.seconds;
  begin_stage(go_on, "wires");
  std::optional<Chart> refined;
  WireNetwork network;
  {
    const StageTimer timer(seconds, "wires");
    refined = process_topology(chart);  // III
    network = build_wire_network(refined ? *refined : chart);
    layout.network = refined ? build_wire_network(chart) : network;
  }
  const Chart& prepared = refined ? *refined : chart;
  begin_stage(go_on, "interior");
  std::optional<Warp> warp;  // ψ (II-A)
  {
    const StageTimer timer(seconds, "interior");
    warp.emplace(prepared, network, options.node_weight, options.inner);
    layout.report.factorizations = warp->interior_factorizations();
  }
  const StageTimer timer(seconds, "lengths");
  const VariationBounds bounds = variation_bounds(prepared, options);
  OuterSolution solution =
      choose_variation(prepared, *warp, bounds, [&] { begin_stage(go_on, "lengths"); });  // II-B, Algorithm 1
  if (!solution.shape.inner.is_feasible) {
    const auto may_go_on = [&] { return go_on("lengths"); };
    const ChartRefinement refined_shape = refine_chart(chart, options, [&](const char*) { return may_go_on(); });
    if (refined_shape.shape.is_exact && !refined_shape.was_stopped) throw needs_refinement(chart);
    throw explain_infeasible(chart, input, options, refined_shape, may_go_on);
  }
  report_solution(solution, layout.report);
  layout.helper_wires = list_helper_wires(prepared, chart.wire_parts.size(), solution.variation);
  layout.variation.assign(solution.variation.begin(),
                          solution.variation.begin() + static_cast<std::ptrdiff_t>(chart.wire_parts.size()));
  layout.uv = std::move(solution.shape.uv);
}

void report_refinement(const ChartRefinement& refined, PieceReport& report) {
  report.inner_solves = refined.inner.num_solves;
  report.outer_iterations = refined.shape.iterations;
  report.factorizations = refined.shape.factorizations + refined.loose.factorizations;
  report.constraint_residual = refined.shape.length_error;
  report.objective = refined.shape.objective;
  if (refined.was_stopped) {
    report.warnings.push_back("Cancelled: the lengths are exact, but the shape could be less distorted.");
  } else if (!refined.shape.converged) {
    report.warnings.push_back("The shape stopped short of the least distortion.");
  }
  report.termination = refined.was_stopped       ? Termination::cancelled
                       : report.warnings.empty() ? Termination::converged
                                                 : Termination::stalled;
}

/// The refined method: wires and surface at once, under the same exact lengths. Once those are reached, cancelling
/// leaves the piece at the best shape so far.
void flatten_by_refining(const Chart& chart, const FlattenInput& input, const Options& options, const GoOn& go_on,
                         Layout& layout) {
  begin_stage(go_on, "start");
  const StageTimer timer(layout.report.seconds, "shape");
  layout.network = build_wire_network(chart);
  ChartRefinement refined = refine_chart(chart, options, go_on);
  if (!refined.shape.is_exact) {
    throw explain_infeasible(chart, input, options, refined, [&] { return go_on("shape"); });
  }
  report_refinement(refined, layout.report);
  layout.variation.assign(refined.shape.variation.begin(), refined.shape.variation.end());
  layout.uv = std::move(refined.shape.uv);
}

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

/// The layout of a sound chart, or why it has none.
Layout solve_chart(const Chart& chart, const FlattenInput& input, const Options& options, const GoOn& go_on) {
  Layout layout;
  try {
    if (std::optional<FlattenError> error = find_short_outline(chart)) throw std::move(*error);
    (options.method == Method::refined ? flatten_by_refining : flatten_by_warping)(chart, input, options, go_on,
                                                                                   layout);
  } catch (const FlattenError& error) {
    layout.error = error;
    if (error.code == ErrorCode::cancelled) layout.report.termination = Termination::cancelled;
  } catch (const std::domain_error&) {  // a factorization broke down, or rounding left no topology for the wires
    layout.error = not_solvable(chart);
  }
  return layout;
}

std::vector<Layout> flatten_charts(const FlattenInput& input, const Charts& charts, const Options& options,
                                   ProgressReport& progress, Reuse& reuse) {
  // Where each stage begins and ends in a chart's share of the time. Nobody knows how many steps it takes: each step is
  // told as a part of what is left.
  struct Span {
    double begin, end;
  };
  const std::map<std::string, Span> spans{{"wires", {0.0, 0.1}},
                                          {"interior", {0.1, 0.6}},
                                          {"lengths", {0.6, 1.0}},
                                          {"start", {0.0, 0.15}},
                                          {"shape", {0.15, 1.0}}};
  constexpr double kPerStep = 0.05;
  std::vector<Layout> layouts;
  double faces_done = 0;
  for (const Chart& chart : charts.charts) {
    const auto chart_faces = static_cast<double>(chart.source_face.size());
    double share_done = 0;
    const auto go_on = [&](const char* stage) {
      const Span& span = spans.at(stage);
      const bool has_begun = span.begin <= share_done;
      share_done = has_begun ? share_done + kPerStep * std::max(0.0, span.end - share_done) : span.begin;
      const double done = (faces_done + share_done * chart_faces) / static_cast<double>(input.faces.rows());
      return progress.go_on(stage, 0.2 + 0.7 * done);
    };
    if (chart.error) {
      layouts.emplace_back().error = with_proposed_seams(*chart.error, chart);
    } else {
      layouts.push_back(reuse.layout_of(chart, [&] { return solve_chart(chart, input, options, go_on); }));
    }
    faces_done += chart_faces;
  }
  return layouts;
}

void pack(const Charts& charts, const Options& options, std::vector<Layout>& layouts) {
  std::vector<Positions2> shapes;
  for (Layout& layout : layouts) shapes.push_back(std::move(layout.uv));
  shapes = pack_pieces(charts.charts, shapes, options);
  for (std::size_t c = 0; c < layouts.size(); ++c) layouts[c].uv = std::move(shapes[c]);
}

}  // namespace

FlattenResult flatten(const FlattenInput& input, const Options& options, const Progress& progress, Cache* cache) {
  std::map<std::string, double> seconds;
  FlattenResult result;
  {
    const StageTimer total(seconds, "total");
    ProgressReport report(progress);

    check_options(options, input.wires.size());
    check_mesh(input);
    const EdgeTable edges(input.faces, static_cast<int>(input.vertices.rows()));
    check_seams_and_wires(input, edges);

    report.go_on("charts", 0);
    Charts charts;
    {
      const StageTimer timer(seconds, "charts");
      charts = cut_into_charts(input, edges);
    }
    Reuse reuse(cache, input, options);
    std::vector<Layout> layouts = flatten_charts(input, charts, options, report, reuse);
    reuse.finish();
    report.go_on("measure", 0.9);
    {
      const StageTimer timer(seconds, "packing");
      pack(charts, options, layouts);
    }
    const StageTimer timer(seconds, "measure");
    result = assemble_result(input, charts, std::move(layouts), options.mirror);
    result.reused_pieces = reuse.num_reused();
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
