// SPDX-License-Identifier: GPL-3.0-or-later
// The pipeline, top-down; the mathematics is in the files it names. native/README.md maps the paper to them.
#include "wirewarp/flatten.h"

#include <stdexcept>

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
#include "topology/process_topology.h"

namespace wirewarp {
namespace {

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

/// The flat shape of one chart. Throws FlattenError where there is none or begin_stage cancels.
void flatten_chart(const Chart& chart, const FlattenInput& input, const Options& options,
                   const std::function<void(const char* stage)>& begin_stage, Layout& layout) {
  std::map<std::string, double>& seconds = layout.report.seconds;
  begin_stage("wires");
  if (std::optional<FlattenError> error = find_short_outline(chart)) throw std::move(*error);
  std::optional<Chart> refined;
  WireNetwork network;
  {
    const StageTimer timer(seconds, "wires");
    refined = process_topology(chart);  // III
    network = build_wire_network(refined ? *refined : chart);
    layout.network = refined ? build_wire_network(chart) : network;
  }
  const Chart& prepared = refined ? *refined : chart;
  begin_stage("interior");
  std::optional<Warp> warp;  // ψ (II-A)
  {
    const StageTimer timer(seconds, "interior");
    warp.emplace(prepared, network, options.node_weight, options.inner);
    layout.report.factorizations = warp->interior_factorizations();
  }
  const StageTimer timer(seconds, "lengths");
  const VariationBounds bounds = variation_bounds(prepared, options);
  OuterSolution solution =
      choose_variation(prepared, *warp, bounds, [&] { begin_stage("lengths"); });  // II-B, Algorithm 1
  if (!solution.shape.inner.is_feasible) {
    throw infeasible_lengths(chart, *layout.network, input.wires, solution.shape.inner);
  }
  report_solution(solution, layout.report);
  layout.helper_wires = list_helper_wires(prepared, chart.wire_parts.size(), solution.variation);
  layout.variation.assign(solution.variation.begin(),
                          solution.variation.begin() + static_cast<std::ptrdiff_t>(chart.wire_parts.size()));
  layout.uv = std::move(solution.shape.uv);
}

std::vector<Layout> flatten_charts(const FlattenInput& input, const Charts& charts, const Options& options,
                                   ProgressReport& progress) {
  // Shares of a run's time at a million triangles.
  const std::map<std::string, double> share_done{{"wires", 0.0}, {"interior", 0.1}, {"lengths", 0.6}};
  std::vector<Layout> layouts(charts.charts.size());
  double faces_done = 0;
  for (std::size_t c = 0; c < layouts.size(); ++c) {
    const Chart& chart = charts.charts[c];
    Layout& layout = layouts[c];
    const auto chart_faces = static_cast<double>(chart.source_face.size());
    const auto begin_stage = [&](const char* stage) {
      const double done = (faces_done + share_done.at(stage) * chart_faces) / static_cast<double>(input.faces.rows());
      if (progress.go_on(stage, 0.2 + 0.7 * done)) return;
      layout.report.termination = Termination::cancelled;
      throw FlattenError(ErrorCode::cancelled, "Cancelled before this piece was flat.");
    };
    if (chart.error) {
      layout.error = with_proposed_seams(*chart.error, chart);
    } else {
      try {
        flatten_chart(chart, input, options, begin_stage, layout);
      } catch (const FlattenError& error) {
        layout.error = error;
      } catch (const std::domain_error&) {  // a factorization broke down
        layout.error = not_solvable(chart);
      }
    }
    faces_done += chart_faces;
  }
  return layouts;
}

void pack(const Charts& charts, const Options& options, std::vector<Layout>& layouts) {
  std::vector<Positions2> shapes;
  for (Layout& layout : layouts) shapes.push_back(std::move(layout.uv));
  shapes = pack_pieces(charts.charts, shapes, options.gap, options.mirror);
  for (std::size_t c = 0; c < layouts.size(); ++c) layouts[c].uv = std::move(shapes[c]);
}

}  // namespace

FlattenResult flatten(const FlattenInput& input, const Options& options, const Progress& progress) {
  std::map<std::string, double> seconds;
  FlattenResult result;
  {
    const StageTimer total(seconds, "total");
    ProgressReport report(progress);

    check_options(options);
    check_mesh(input);
    const EdgeTable edges(input.faces, static_cast<int>(input.vertices.rows()));
    check_seams_and_wires(input, edges);

    report.go_on("charts", 0);
    Charts charts;
    {
      const StageTimer timer(seconds, "charts");
      charts = cut_into_charts(input, edges);
    }
    std::vector<Layout> layouts = flatten_charts(input, charts, options, report);
    report.go_on("measure", 0.9);
    {
      const StageTimer timer(seconds, "packing");
      pack(charts, options, layouts);
    }
    const StageTimer timer(seconds, "measure");
    result = assemble_result(input, charts, std::move(layouts), options.mirror);
    report.go_on("measure", 1);
  }
  for (const Piece& piece : result.pieces) {
    for (const auto& [stage, time] : piece.report.seconds) seconds[stage] += time;
  }
  result.seconds = seconds;
  result.method = options.method == Method::wirewarping ? "wirewarping" : "wirewarp++";
  return result;
}

}  // namespace wirewarp
