// SPDX-License-Identifier: GPL-3.0-or-later
// Measures and checks a flattening from any program.
#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "base/progress_report.h"
#include "result/assemble_result.h"
#include "result/lengths.h"
#include "surface/charts/cut_into_charts.h"
#include "surface/check_input/check_input.h"

namespace wirewarp {
namespace {

/// Flat corners of one vertex count as separate if their distance, divided by the piece's size, is above this.
/// Single precision and files with six decimals round by less.
constexpr double kSamePoint = 1e-6;

/// The flat corners of a chart's faces: one position per half-edge with a face, at its start.
class FlatCorners {
 public:
  /// Throws no_layout unless all positions are finite and below kCoordinateLimit.
  FlatCorners(const Chart& chart, const CornerUv& corner_uv) : mesh_(chart.mesh), uv_(mesh_.n_halfedges(), 2) {
    std::vector<int> bad;
    for (const FaceHandle f : mesh_.faces()) {
      const int source = chart.source_face[f.idx()];
      if (!(corner_uv.row(source).array().abs() < kCoordinateLimit).all()) bad.push_back(source);
      HalfedgeHandle h = mesh_.halfedge_handle(f);
      for (int k = 0; k < 3; ++k, h = mesh_.next_halfedge_handle(h)) {
        uv_.row(h.idx()) = corner_uv.block<1, 2>(source, 2 * k);
        low_ = low_.cwiseMin(uv_.row(h.idx()));
        high_ = high_.cwiseMax(uv_.row(h.idx()));
      }
    }
    if (bad.empty()) return;
    throw FlattenError(ErrorCode::no_layout, ErrorArguments{{"limit", kCoordinateLimit}}, {{}, {}, bad});
  }

  Eigen::RowVector2d operator[](HalfedgeHandle h) const { return uv_.row(h.idx()); }

  /// Returns whether the two faces at an edge have different positions for the vertex at the start of h.
  bool is_torn(HalfedgeHandle h) const {
    const HalfedgeHandle opposite = mesh_.opposite_halfedge_handle(h);
    if (mesh_.is_boundary(h) || mesh_.is_boundary(opposite)) return false;
    const Eigen::RowVector2d gap = uv_.row(h.idx()) - uv_.row(mesh_.next_halfedge_handle(opposite).idx());
    return gap.norm() > kSamePoint * (high_ - low_).maxCoeff();
  }

 private:
  const HalfEdgeMesh& mesh_;
  Positions2 uv_;
  Eigen::RowVector2d low_ = Eigen::RowVector2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::RowVector2d high_ = -low_;
};

void check_not_torn(const Chart& chart, const FlatCorners& corners) {
  std::set<int> vertices;
  std::set<VertexPair> edges;
  for (const HalfedgeHandle h : chart.mesh.halfedges()) {
    if (!corners.is_torn(h)) continue;
    vertices.insert(chart.source_vertex[chart.mesh.from_vertex_handle(h).idx()]);
    edges.insert(source_edge(chart, h));
  }
  if (edges.empty()) return;
  const std::vector<VertexPair> torn(edges.begin(), edges.end());
  throw FlattenError(ErrorCode::uv_discontinuous, ErrorArguments{}, {{vertices.begin(), vertices.end()}, torn, {}});
}

/// Returns one position per chart vertex. Throws no_layout or uv_discontinuous.
Positions2 gather_corners(const Chart& chart, const CornerUv& corner_uv) {
  const FlatCorners corners(chart, corner_uv);
  check_not_torn(chart, corners);
  Positions2 uv(static_cast<int>(chart.mesh.n_vertices()), 2);
  for (const HalfedgeHandle h : chart.mesh.halfedges()) {
    if (!chart.mesh.is_boundary(h)) uv.row(chart.mesh.from_vertex_handle(h).idx()) = corners[h];
  }
  return uv;
}

SolvedChart read_chart(const Chart& chart, const CornerUv& corner_uv) {
  SolvedChart solved;
  solved.report.termination = Termination::measured;
  solved.error = chart.error;
  if (chart.error) return solved;
  try {
    solved.uv = gather_corners(chart, corner_uv);
    solved.variation = fit_variation(chart, solved.uv);
    solved.network = build_wire_network(chart);
  } catch (const FlattenError& error) {
    solved.error = error;
  }
  return solved;
}

/// Sets the same h for all sides of an elastic seam: the mean of the values that fit the sides, within the tolerance.
void share_variations(const std::vector<Chart>& charts, std::vector<SolvedChart>& solved) {
  struct Mean {
    double sum = 0;
    int count = 0;
  };
  std::map<std::pair<int, int>, Mean> means;  // keyed by wire and part
  const auto for_each_side = [&](const auto& visit) {
    for (std::size_t c = 0; c < charts.size(); ++c) {
      for (std::size_t i = 0; i < solved[c].variation.size(); ++i) {
        const WirePart& part = charts[c].wire_parts[i];
        if (is_elastic_boundary(part)) visit(part, means[{part.wire_index, part.part}], solved[c].variation[i]);
      }
    }
  };
  for_each_side([](const WirePart& /*part*/, Mean& mean, double h) { mean = {mean.sum + h, mean.count + 1}; });
  for_each_side([](const WirePart& part, const Mean& mean, double& h) {
    h = std::clamp(mean.sum / mean.count, part.ease - part.tolerance, part.ease + part.tolerance);
  });
}

void check_corners(const FlattenInput& input, const CornerUv& corner_uv) {
  if (corner_uv.rows() == input.faces.rows()) return;
  throw FlattenError(
      ErrorCode::invalid_shape,
      ErrorArguments{{"name", "corner_uv"},
                     {"found", "(" + std::to_string(corner_uv.rows()) + ", 3, 2)"},
                     {"wanted", "(" + std::to_string(input.faces.rows()) + ", 3, 2), one row per face"}});
}

}  // namespace

FlattenResult measure(const FlattenInput& input, const CornerUv& corner_uv) {
  std::map<std::string, double> seconds;
  FlattenResult result;
  {
    const StageTimer total(seconds, "total");
    check_mesh(input);
    check_corners(input, corner_uv);
    const EdgeTable edges(input.faces, static_cast<int>(input.vertices.rows()));
    check_faces_share_edges(input, edges);
    check_seams_and_wires(input, edges);
    Charts charts;
    {
      const StageTimer timer(seconds, "charts");
      charts = cut_into_charts(input, edges);
    }
    const StageTimer timer(seconds, "measure");
    std::vector<SolvedChart> solved_charts;
    for (const Chart& chart : charts.charts) solved_charts.push_back(read_chart(chart, corner_uv));
    share_variations(charts.charts, solved_charts);
    result = assemble_result(input, charts, std::move(solved_charts), {});
  }
  result.corner_uv = corner_uv;
  result.seconds = std::move(seconds);
  result.method = "measure";
  return result;
}

}  // namespace wirewarp
