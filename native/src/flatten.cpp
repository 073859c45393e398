// SPDX-License-Identifier: GPL-3.0-or-later
// The pipeline, top-down; the mathematics is in the files it names. native/README.md maps the paper to them.
#include "wirewarp/flatten.h"

#include <set>
#include <stdexcept>

#include "charts/cut_into_charts.h"
#include "check_input/check_input.h"
#include "check_input/sentence.h"
#include "index.h"
#include "mesh/geometry.h"
#include "metrics/assemble_result.h"
#include "outer/choose_variation.h"
#include "packing/pack_pieces.h"
#include "progress_report.h"
#include "topology/process_topology.h"

namespace wirewarp {
namespace {

FlattenError infeasible_lengths(const Chart& chart, const WireNetwork& network, const std::vector<Wire>& wires,
                                const InnerSolution& solution) {
  std::set<int> in_chart;
  for (const WirePart& part : chart.wire_parts) {
    if (part.kind != WireKind::boundary) in_chart.insert(part.wire_index);
  }
  const std::string names = in_chart.empty() ? "" : " and " + name_wires(wires, {in_chart.begin(), in_chart.end()});
  ErrorElements elements;
  for (const WireEdge& edge : network.edges) {
    elements.edges.push_back(source_edge(chart, chart.mesh.halfedge_handle(edge.edge, 0)));
  }
  elements.faces = chart.source_face;
  return FlattenError(ErrorCode::infeasible_lengths,
                      "The outline" + names + " of the piece around face " + std::to_string(chart.source_face.front()) +
                          " cannot keep " + (in_chart.empty() ? "its length" : "their lengths") +
                          " in the plane (a gap of " + percent(solution.closure_residual) + " of a loop stays open): " +
                          (in_chart.empty() ? "" : "clear a wire or ") + "mark another seam.",
                      elements);
}

FlattenError not_solvable(const Chart& chart) {
  return FlattenError(ErrorCode::not_solvable,
                      "The piece around face " + std::to_string(chart.source_face.front()) +
                          " cannot be laid out in double precision, for its faces differ too much in size: merge "
                          "vertices that lie very close together, or remesh it.",
                      {{}, {}, chart.source_face});
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

/// Takes what a solution says of the helper wires, the parts after the chart's own.
void report_helper_wires(const Chart& prepared, std::size_t num_own_parts, const OuterSolution& solution,
                         Layout& layout) {
  for (std::size_t i = num_own_parts; i < prepared.wire_parts.size(); ++i) {
    const HalfEdgeChain& chain = prepared.wire_parts[i].half_edges;
    std::vector<int> vertices{prepared.mesh.from_vertex_handle(chain.front()).idx()};
    for (const HalfedgeHandle h : chain) vertices.push_back(prepared.mesh.to_vertex_handle(h).idx());
    HelperWire helper;
    helper.points_3d.resize(static_cast<Eigen::Index>(vertices.size()), 3);
    for (int k = 0; k < helper.points_3d.rows(); ++k) {
      const auto point = prepared.mesh.point(VertexHandle(vertices[at(k)]));
      helper.points_3d.row(k) << point[0], point[1], point[2];
    }
    for (const HalfedgeHandle h : chain) helper.length_3d += edge_length(prepared.mesh, h);
    helper.variation = solution.variation[static_cast<Eigen::Index>(i)];
    helper.length_2d = (1 + helper.variation) * helper.length_3d;
    layout.helper_wires.push_back(std::move(helper));
    layout.helper_vertices.push_back(std::move(vertices));
  }
}

/// The flat shape of one chart. Throws FlattenError where there is none or begin_stage cancels.
void flatten_chart(const Chart& chart, const FlattenInput& input, const Options& options,
                   const std::function<void(const char* stage)>& begin_stage, Layout& layout) {
  std::map<std::string, double>& seconds = layout.report.seconds;
  begin_stage("wires");
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
  const VariationBounds bounds = variation_bounds(prepared, options.method);
  OuterSolution solution =
      choose_variation(prepared, *warp, bounds, [&] { begin_stage("lengths"); });  // II-B, Algorithm 1
  if (!solution.shape.inner.is_feasible) {
    throw infeasible_lengths(chart, *layout.network, input.wires, solution.shape.inner);
  }
  report_solution(solution, layout.report);
  report_helper_wires(prepared, chart.wire_parts.size(), solution, layout);
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
    layout.error = chart.error;
    if (!layout.error) {
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
