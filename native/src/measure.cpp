// SPDX-License-Identifier: GPL-3.0-or-later
// The same measures and promises for a flattening made elsewhere.
#include "charts/cut_into_charts.h"
#include "check_input/check_input.h"
#include "check_input/sentence.h"
#include "index.h"
#include "metrics/assemble_result.h"
#include "metrics/lengths.h"

namespace wirewarp {
namespace {

/// Corners of one vertex that lie farther apart than this fraction of the flattening's size are cut from each other.
constexpr double kSamePoint = 1e-6;

/// One position per chart vertex. Throws no_layout or uv_discontinuous.
Positions2 gather_corners(const Chart& chart, const CornerUv& corner_uv) {
  std::vector<int> not_finite;
  double size = 0;
  for (int f : chart.source_face) {
    if (!corner_uv.row(f).allFinite()) not_finite.push_back(f);
    size = std::max(size, corner_uv.row(f).maxCoeff() - corner_uv.row(f).minCoeff());
  }
  if (!not_finite.empty()) {
    throw FlattenError(ErrorCode::no_layout,
                       "There are no finite coordinates at the corners of " + name_elements("face", not_finite) +
                           ": flatten the whole piece.",
                       {{}, {}, not_finite});
  }
  Positions2 uv(static_cast<int>(chart.mesh.n_vertices()), 2);
  std::vector<char> is_set(chart.mesh.n_vertices(), 0);
  std::vector<int> torn;
  for (const FaceHandle f : chart.mesh.faces()) {
    HalfedgeHandle h = chart.mesh.halfedge_handle(f);
    for (int k = 0; k < 3; ++k, h = chart.mesh.next_halfedge_handle(h)) {
      const int v = chart.mesh.from_vertex_handle(h).idx();
      const Eigen::RowVector2d corner = corner_uv.block<1, 2>(chart.source_face[at(f.idx())], 2 * k);
      if (!is_set[at(v)]) uv.row(v) = corner;
      is_set[at(v)] = 1;
      if ((uv.row(v) - corner).norm() > kSamePoint * size) torn.push_back(chart.source_vertex[at(v)]);
    }
  }
  if (!torn.empty()) {
    throw FlattenError(ErrorCode::uv_discontinuous,
                       "The flattening is cut at " + name_elements("vertex", torn) +
                           ", where no seam is: hand over its cuts as seams.",
                       {torn, {}, {}});
  }
  return uv;
}

}  // namespace

FlattenResult measure(const FlattenInput& input, const CornerUv& corner_uv) {
  check_mesh(input);
  if (corner_uv.rows() != input.faces.rows()) {
    throw FlattenError(ErrorCode::invalid_shape, "corner_uv has " + std::to_string(corner_uv.rows()) + " faces and " +
                                                     "the mesh " + std::to_string(input.faces.rows()) +
                                                     ": give three corners for each face.");
  }
  const EdgeTable edges(input.faces, static_cast<int>(input.vertices.rows()));
  check_seams_and_wires(input, edges);
  const Charts charts = cut_into_charts(input, edges);

  std::vector<Layout> layouts(charts.charts.size());
  for (std::size_t c = 0; c < layouts.size(); ++c) {
    const Chart& chart = charts.charts[c];
    Layout& layout = layouts[c];
    layout.report.termination = Termination::measured;
    layout.error = chart.error;
    if (chart.error) continue;
    try {
      layout.uv = gather_corners(chart, corner_uv);
      layout.variation = fit_variation(chart, layout.uv);
      layout.network = build_wire_network(chart);
    } catch (const FlattenError& error) {
      layout.error = error;
    }
  }
  FlattenResult result = assemble_result(input, charts, std::move(layouts), false);
  result.corner_uv = corner_uv;
  result.method = "measure";
  return result;
}

}  // namespace wirewarp
