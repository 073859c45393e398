// SPDX-License-Identifier: GPL-3.0-or-later
// The pipeline, top-down; the mathematics is in the files it names. native/README.md maps the paper to them.
#include "wirewarp/flatten.h"

#include "charts/cut_into_charts.h"
#include "check_input/check_input.h"
#include "check_input/sentence.h"
#include "inner/inner_problem.h"
#include "inner/interior_placement.h"
#include "inner/wire_layout.h"
#include "metrics/assemble_result.h"
#include "packing/pack_pieces.h"
#include "progress_report.h"

namespace wirewarp {
namespace {

/// The 3D lengths of the wire edges: all wires are rigid.
Eigen::VectorXd rest_lengths(const WireNetwork& network) {
  Eigen::VectorXd lengths(static_cast<Eigen::Index>(network.edges.size()));
  for (Eigen::Index e = 0; e < lengths.size(); ++e) lengths[e] = network.edges[static_cast<std::size_t>(e)].length;
  return lengths;
}

FlattenError infeasible_lengths(const Chart& chart, const InnerSolution& solution) {
  std::vector<int> wires;
  for (const WirePart& part : chart.wire_parts) {
    if (part.kind != WireKind::boundary && (wires.empty() || wires.back() != part.wire_index)) {
      wires.push_back(part.wire_index);
    }
  }
  const std::string names = wires.empty() ? "The outline" : "The outline and " + name_elements("wire", wires);
  return FlattenError(ErrorCode::infeasible_lengths,
                      names + " of the piece around face " + std::to_string(chart.source_face.front()) +
                          " cannot keep their lengths in the plane (a gap of " +
                          std::to_string(100 * solution.closure_residual) +
                          " % of a loop stays open): clear a wire or mark another seam.",
                      {{}, {}, chart.source_face});
}

/// ψ: the flat shape of one chart (paper II-A). Throws FlattenError where there is none or begin_stage cancels.
void flatten_chart(const Chart& chart, const FlattenInput& input, const Options& options,
                   const std::function<void(const char* stage)>& begin_stage, Layout& layout) {
  std::map<std::string, double>& seconds = layout.report.seconds;

  begin_stage("wires");
  Eigen::VectorXd lengths;
  {
    const StageTimer timer(seconds, "wires");
    layout.network = build_wire_network(chart);
    check_wire_network(chart, *layout.network, input.wires);
    lengths = rest_lengths(*layout.network);
    layout.variation.assign(chart.wire_parts.size(), 0.0);
  }
  begin_stage("lengths");
  Positions2 uv(static_cast<int>(chart.mesh.n_vertices()), 2);
  {
    const StageTimer timer(seconds, "lengths");
    InnerProblem inner(*layout.network, options.node_weight);
    const InnerSolution solution = inner.solve(lengths, options.inner);  // Eq. (1)
    layout.report.inner_solves = solution.num_solves;
    layout.report.constraint_residual = solution.closure_residual;
    layout.report.projected_gradient = solution.projected_gradient;
    if (!solution.is_feasible) throw infeasible_lengths(chart, solution);
    layout.report.termination = solution.is_minimum ? Termination::converged : Termination::stalled;
    if (!solution.is_minimum) layout.report.warnings.push_back("The wire angles stopped short of their minimum.");
    lay_out_wires(chart, *layout.network, solution.headings, lengths, uv);
  }
  begin_stage("interior");
  {
    const StageTimer timer(seconds, "interior");
    const InteriorPlacement placement(chart, *layout.network);
    placement.place(uv);
    layout.report.factorizations = placement.factorizations();
  }
  layout.uv = std::move(uv);
}

std::vector<Layout> flatten_charts(const FlattenInput& input, const Charts& charts, const Options& options,
                                   ProgressReport& progress) {
  // Shares of a run's time at a million triangles.
  const std::map<std::string, double> share_done{{"wires", 0.0}, {"lengths", 0.1}, {"interior", 0.15}};
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
  result.method = "wirewarping";
  return result;
}

}  // namespace wirewarp
