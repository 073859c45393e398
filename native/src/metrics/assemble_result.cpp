// SPDX-License-Identifier: GPL-3.0-or-later
#include "metrics/assemble_result.h"

#include <limits>

#include "index.h"
#include "mesh/geometry.h"
#include "metrics/guarantee.h"
#include "metrics/lengths.h"
#include "metrics/metrics.h"
#include "packing/pack_pieces.h"

namespace wirewarp {
namespace {

Piece assemble_piece(const FlattenInput& input, const Chart& chart, Layout& layout, bool mirror) {
  Piece piece;
  piece.source_face = chart.source_face;
  piece.source_vertex = chart.source_vertex;
  piece.faces = triangles_of(chart.mesh);
  piece.report = std::move(layout.report);
  piece.error = std::move(layout.error);
  if (layout.uv.rows() == 0) {
    piece.vertices.setConstant(static_cast<int>(chart.source_vertex.size()), 2,
                               std::numeric_limits<double>::quiet_NaN());
    if (piece.report.termination != Termination::cancelled) piece.report.termination = Termination::failed;
  } else {
    const Positions2 seen_from_outside = mirror ? mirror_image(layout.uv) : layout.uv;
    piece.metrics = measure_metrics(chart, *layout.network, seen_from_outside);
    piece.wires = measure_wire_parts(chart, input.wires, layout.uv, layout.variation);
    piece.boundaries = measure_boundaries(chart, layout.uv);
    if (!piece.error) {
      piece.error = check_guarantee(chart, *layout.network, input.wires, layout.uv, layout.variation, piece.metrics);
    }
    piece.vertices = std::move(layout.uv);
  }
  piece.report.message = piece.error ? piece.error->what() : "Every promise is kept: lengths, no flips, no overlap.";
  return piece;
}

void write_corners(const Piece& piece, CornerUv& corner_uv) {
  for (int f = 0; f < piece.faces.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      // The half-edge of a chart face begins at the input face's first corner.
      corner_uv.block<1, 2>(piece.source_face[at(f)], 2 * k) = piece.vertices.row(piece.faces(f, k));
    }
  }
}

}  // namespace

FlattenResult assemble_result(const FlattenInput& input, const Charts& charts, std::vector<Layout> layouts,
                              bool mirror) {
  FlattenResult result;
  result.corner_uv.setConstant(input.faces.rows(), 6, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t c = 0; c < charts.charts.size(); ++c) {
    result.pieces.push_back(assemble_piece(input, charts.charts[c], layouts[c], mirror));
    write_corners(result.pieces.back(), result.corner_uv);
  }
  result.seams = measure_seams(charts, result.pieces, input.vertices);
  result.wires = measure_whole_wires(input, charts, result.pieces);
  return result;
}

}  // namespace wirewarp
