// SPDX-License-Identifier: GPL-3.0-or-later
#include "result/assemble_result.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "base/work_meter.h"
#include "result/guarantee.h"
#include "result/lengths.h"
#include "result/metrics.h"
#include "result/pack_pieces.h"
#include "surface/mesh/geometry.h"

namespace wirewarp {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Sets the vertices and faces of a piece whose chart has no mesh because of faults: one vertex per input vertex.
void take_input_faces(const FlattenInput& input, const Chart& chart, Piece& piece) {
  piece.faces.resize(static_cast<Eigen::Index>(chart.source_face.size()), 3);
  for (int f = 0; f < piece.faces.rows(); ++f) piece.faces.row(f) = input.faces.row(chart.source_face[f]);
  std::vector<int>& vertices = piece.source_vertex;
  vertices.assign(piece.faces.data(), piece.faces.data() + piece.faces.size());
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  piece.faces = piece.faces.unaryExpr([&](int v) {
    return static_cast<int>(std::lower_bound(vertices.begin(), vertices.end(), v) - vertices.begin());
  });
}

/// Returns the metrics of a piece without a flat shape. Only its 3D area is known.
Metrics unknown_metrics(const FlattenInput& input, const std::vector<int>& faces) {
  Metrics metrics;
  metrics.arap_energy = metrics.angle_deviation_rms = metrics.angle_deviation_max = metrics.area_2d = kNaN;
  metrics.face_arap.setConstant(static_cast<Eigen::Index>(faces.size()), kNaN);
  metrics.face_aspect_ratio = metrics.face_weft_strain = metrics.face_warp_strain = metrics.face_shear_angle =
      metrics.face_arap;
  for (const int f : faces) {
    const Eigen::Vector3d origin = input.vertices.row(input.faces(f, 0));
    const Eigen::Vector3d along = input.vertices.row(input.faces(f, 1)).transpose() - origin;
    const Eigen::Vector3d back = input.vertices.row(input.faces(f, 2)).transpose() - origin;
    metrics.area_3d += along.cross(back).norm() / 2;
  }
  return metrics;
}

Piece assemble_piece(const FlattenInput& input, const Chart& chart, SolvedChart& solved, const Options& options,
                     const StopToken& stop) {
  Piece piece;
  piece.source_face = chart.source_face;
  if (chart.mesh.n_faces() > 0) {
    piece.source_vertex = chart.source_vertex;
    piece.faces = triangles_of(chart.mesh);
  } else {
    take_input_faces(input, chart, piece);
  }
  piece.report = std::move(solved.report);
  piece.error = std::move(solved.error);
  if (solved.uv.rows() == 0) {
    piece.vertices.setConstant(static_cast<Eigen::Index>(piece.source_vertex.size()), 2, kNaN);
    piece.metrics = unknown_metrics(input, piece.source_face);
    if (piece.report.termination != Termination::cancelled) piece.report.termination = Termination::failed;
  } else {
    piece.helper_wires = place_helper_wires(std::move(solved.helper_wires), solved.uv);
    solved.uv.conservativeResize(static_cast<Eigen::Index>(chart.mesh.n_vertices()), 2);
    const Positions2 seen_from_outside = options.mirror ? mirror_image(solved.uv) : solved.uv;
    piece.metrics = measure_metrics(chart, *solved.network, seen_from_outside, stop);
    if (options.cloth) {
      piece.metrics.cloth_energy = measure_cloth_energy(chart, seen_from_outside, *options.cloth);
      const std::optional<std::string> warning = warn_of_limits(chart, piece.metrics, *options.cloth);
      if (warning) piece.report.warnings.push_back(*warning);
    }
    piece.wires = measure_wire_parts(chart, input.wires, solved.uv, solved.variation);
    piece.boundaries = measure_boundaries(chart, solved.uv, solved.variation);
    if (!piece.error) {
      piece.error = check_guarantee(chart, *solved.network, input.wires, solved.uv, solved.variation, piece.metrics,
                                    solved.proposed_seams);
    }
    piece.vertices = std::move(solved.uv);
  }
  piece.report.message = piece.error ? piece.error->what() : "All guarantees hold: lengths, no flips, no overlap.";
  return piece;
}

void write_corners(const Piece& piece, CornerUv& corner_uv) {
  for (int f = 0; f < piece.faces.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      // The first half-edge of a chart face starts at the first corner of the input face, so corner k is the same in
      // both.
      corner_uv.block<1, 2>(piece.source_face[f], 2 * k) = piece.vertices.row(piece.faces(f, k));
    }
  }
}

}  // namespace

FlattenResult assemble_result(const FlattenInput& input, const Charts& charts, std::vector<SolvedChart> solved_charts,
                              const Options& options, const StopToken& stop) {
  WorkMeter work(stop);
  FlattenResult result;
  result.corner_uv.setConstant(input.faces.rows(), 6, kNaN);
  for (std::size_t c = 0; c < charts.charts.size(); ++c) {
    work.did(charts.charts[c].source_face.size());
    result.pieces.push_back(assemble_piece(input, charts.charts[c], solved_charts[c], options, stop));
    write_corners(result.pieces.back(), result.corner_uv);
  }
  result.seams = measure_seams(input, charts, result.pieces);
  result.wires = measure_whole_wires(input, charts, result.pieces);
  return result;
}

}  // namespace wirewarp
