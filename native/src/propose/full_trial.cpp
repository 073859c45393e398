// SPDX-License-Identifier: GPL-3.0-or-later
#include "propose/full_trial.h"

#include <algorithm>

#include "mesh/geometry.h"
#include "metrics/widespread.h"
#include "stop_token.h"

namespace wirewarp {

PieceFigures figures_of(const FlattenResult& result, const Chart& chart, const Options& options) {
  PieceFigures figures;
  figures.error = chart.error;
  if (chart.error) return figures;
  std::vector<double> areas;
  for (const FaceHandle f : chart.mesh.faces()) areas.push_back(face_area(chart.mesh, f));
  Eigen::VectorXd strains(static_cast<Eigen::Index>(areas.size()));
  double energy = 0;
  for (const Piece& piece : result.pieces) {
    const Metrics& metrics = piece.metrics;
    for (std::size_t f = 0; f < piece.source_face.size(); ++f) {
      const auto face = std::lower_bound(chart.source_face.begin(), chart.source_face.end(), piece.source_face[f]);
      if (face == chart.source_face.end() || *face != piece.source_face[f]) break;  // a piece of another chart
      strains[face - chart.source_face.begin()] = metrics.face_aspect_ratio[static_cast<Eigen::Index>(f)] - 1;
      if (f > 0) continue;
      if (piece.error) figures.error = piece.error;
      figures.area += metrics.area_3d;
      energy += (options.cloth ? metrics.cloth_energy : metrics.arap_energy) * metrics.area_3d;
    }
  }
  figures.energy = energy / figures.area;
  if (!figures.error) figures.strain = widespread(areas, strains);
  return figures;
}

FlattenInput with_seams(FlattenInput input, const std::vector<VertexPair>& edges) {
  const Eigen::Index given = input.seams.rows();
  input.seams.conservativeResize(given + static_cast<Eigen::Index>(edges.size()), 2);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    input.seams.row(given + static_cast<Eigen::Index>(i)) << edges[i][0], edges[i][1];
  }
  return input;
}

FullTrials::FullTrials(const FlattenInput& input, const Options& options, const std::function<bool()>& go_on)
    : input_(input), options_(options), go_on_(go_on) {
  options_.with_proposals = false;
}

FlattenResult FullTrials::run(const std::vector<VertexPair>& cut) {
  FlattenResult result = flatten_with(
      with_seams(with_seams(input_, taken_), cut), options_, [&](const std::string&, double) { return go_on_(); },
      &cache_);
  if (!go_on_()) throw Stopped();
  return result;
}

}  // namespace wirewarp
