// SPDX-License-Identifier: GPL-3.0-or-later
#include "cuts/propose/merge_smooth.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/attempt.h"
#include "cuts/parts/part_planes.h"
#include "cuts/propose/canonical_order.h"
#include "cuts/propose/flat_width.h"
#include "cuts/propose/line_evaluation.h"
#include "cuts/propose/merge_sections.h"
#include "cuts/propose/mirror_image.h"

namespace wirewarp {
namespace {

/// Pieces of the fine set may need this many times the strain for which they are merged. With a smaller factor, many
/// lines of the set keep their zigzags.
constexpr double kFineGrowth = 2;

/// Strains that differ by less than this factor count as equal, because shapes are exact only to about 1e-6.
constexpr double kRoundedFigure = 1 + 1e-6;

}  // namespace

SmoothMerger::SmoothMerger(const PieceToCut& piece, double least_solidity, const CutOptions& cut_options,
                           const ExactEvaluation& exact)
    : piece_(piece),
      least_solidity_(least_solidity),
      cut_options_(cut_options),
      exact_(exact),
      unstopped_(exact.surface(), exact.options(), StopToken()) {}

bool SmoothMerger::start(const DartProposal& set, const CutMask& cut, double most_strain) {
  lines_ = lines_along(piece_.chart, piece_.image, cut);
  const SmoothLimits limits{std::max(set.strain, kFineGrowth * most_strain)};
  std::optional<DartProposal> smooth = smooth_lines(set, lines_, limits, piece_, cut_options_, exact_);
  if (!smooth) return false;
  set_ = std::move(*smooth);
  return true;
}

SmoothMerger::CutSet SmoothMerger::set_along(std::vector<SurfacePath> paths) const {
  const FlattenInput& given = exact_.surface().given();
  const CutMesh cut = cut_mesh(given.vertices, given.faces, paths);
  const CutSurface surface(piece_.pieces, piece_.index, unstopped_, cut);
  const FlatPieces parts = parts_of(surface.after(), surface.chart());
  return {with_lines(set_, std::move(paths), surface, figures_of(parts)), parts, cut.sources.faces};
}

bool SmoothMerger::merge(double share, double most_strain, const std::function<void(double)>& report) {
  const FlattenInput& given = exact_.surface().given();
  const CutMesh mesh = cut_mesh(given.vertices, given.faces, set_.paths);
  const CutSurface surface(piece_.pieces, piece_.index, exact_, mesh);
  const Chart& uncut = surface.chart();
  const Chart chart = in_canonical_order(uncut, exact_.stop());
  std::vector<VertexHandle> image;
  if (!piece_.image.empty())
    image = mirror_image(chart, mirror_plane(piece_.chart.mesh, piece_.image).normal.transpose());
  const MirroredCuts mirrored(chart, image);
  const CutMask cut = PartMap(chart).mask_of(mesh.edges);
  const double allowed = std::max(most_strain, set_.strain);
  SectionMerger merger({cut, surface.after()}, chart, mirrored, surface.exact(),
                       {cut_options_.narrowest, least_solidity_});
  for (int i = 0;; ++i) {
    const bool stopped = was_stopped([&] {
      // After the last attempt, merges are only undone, so that the other merges remain.
      if (i < kMostMerges)
        merger.run(share * most_strain, report);
      else
        exact_.stop().check();
    });
    SurfaceLines lines = lines_across(given, piece_.chart, mesh, chart, image, merger.state().cut);
    std::vector<SurfacePath> paths;
    for (const SurfaceLine& line : lines.lines) paths.push_back(path_of(given, piece_.chart, line));
    CutSet merged = set_along(std::move(paths));
    if (merged.set.strain <= allowed * kRoundedFigure) {
      set_ = std::move(merged.set);
      lines_ = std::move(lines);
      num_narrow_ = count_narrow(merged.pieces, cut_options_.narrowest);
      return !stopped;
    }
    if (stopped) return false;
    const FlatPieces joined = parts_of(merger.state().pieces, uncut);
    if (!merger.undo(failed_on_mesh({joined, mesh.sources.faces}, {merged.pieces, merged.faces}, allowed))) break;
  }
  lines_ = lines_across(given, piece_.chart, mesh, chart, image, cut);
  num_narrow_ = count_narrow(parts_of(surface.after(), uncut), cut_options_.narrowest);
  return true;
}

DartProposal SmoothMerger::smooth(double most_strain) const {
  SmoothLimits limits{std::max(most_strain, set_.strain)};
  limits.num_narrow = num_narrow_;
  return smooth_lines(set_, lines_, limits, piece_, cut_options_, exact_).value_or(set_);
}

}  // namespace wirewarp
