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
#include "cuts/propose/mirror_image.h"

namespace wirewarp {
namespace {

std::vector<VertexHandle> image_across_same_plane(const Chart& chart, const PieceToCut& piece) {
  if (piece.image.empty()) return {};
  return mirror_image(chart, mirror_plane(piece.chart.mesh, piece.image).normal.transpose());
}

}  // namespace

SmoothMerger::SmoothMerger(const PieceToCut& piece, const MergeRules& rules, const CutOptions& cut_options,
                           const ExactEvaluation& exact)
    : piece_(piece),
      rules_(rules),
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

SmoothMerger::CutSet SmoothMerger::set_along(SurfaceLines lines) const {
  const FlattenInput& given = exact_.surface().given();
  std::vector<SurfacePath> paths = paths_of(given, piece_.chart, lines);
  const CutMesh cut = cut_mesh(given.vertices, given.faces, paths);
  const CutSurface surface(piece_.pieces, piece_.index, unstopped_, cut);
  const FlatPieces parts = parts_of(surface.after(), surface.chart());
  return {with_lines(set_, std::move(paths), surface, figures_of(parts)), std::move(lines), parts, cut.sources.faces};
}

void SmoothMerger::keep_lines(SurfaceLines lines, const FlatPieces& pieces) {
  lines_ = std::move(lines);
  num_narrow_ = count_narrow(pieces, rules_.narrowest);
}

bool SmoothMerger::merge(double share, double most_strain, const std::function<void(double)>& report) {
  const FlattenInput& given = exact_.surface().given();
  const CutMesh mesh = cut_mesh(given.vertices, given.faces, set_.paths);
  const CutSurface surface(piece_.pieces, piece_.index, exact_, mesh);
  const Chart& uncut = surface.chart();
  const Chart chart = in_canonical_order(uncut, exact_.stop());
  const std::vector<VertexHandle> image = image_across_same_plane(chart, piece_);
  const auto lines_of = [&](const CutMask& cut) { return lines_across(given, piece_.chart, mesh, chart, image, cut); };
  const MirroredCuts mirrored(chart, image);
  const CutState first{PartMap(chart).mask_of(mesh.edges), surface.after()};
  const double allowed = std::max(most_strain, set_.strain) + kStrainError;
  SectionMerger merger(first, chart, mirrored, surface.exact(), rules_);
  for (int i = 0;; ++i) {
    const bool stopped = was_stopped([&] {
      // After the last attempt, merges are only undone, so that the other merges remain.
      if (i < rules_.most_attempts)
        merger.run(share * most_strain, report);
      else
        exact_.stop().check();
    });
    CutSet merged = set_along(lines_of(merger.state().cut));
    if (merged.set.strain <= allowed) {
      set_ = std::move(merged.set);
      keep_lines(std::move(merged.lines), merged.pieces);
      return !stopped;
    }
    if (stopped) return false;
    const FlatPieces joined = parts_of(merger.state().pieces, uncut);
    if (!merger.undo(failed_on_mesh({joined, mesh.sources.faces}, {merged.pieces, merged.faces}, allowed))) break;
  }
  keep_lines(lines_of(first.cut), parts_of(first.pieces, uncut));
  return true;
}

DartProposal SmoothMerger::smooth(double most_strain) const {
  SmoothLimits limits{std::max(most_strain, set_.strain)};
  limits.num_narrow = num_narrow_;
  return smooth_lines(set_, lines_, limits, piece_, cut_options_, exact_).value_or(set_);
}

}  // namespace wirewarp
