// SPDX-License-Identifier: GPL-3.0-or-later
#include "cuts/propose/best_cuts.h"

namespace wirewarp {
namespace {

std::vector<DartProposal> propose_cuts(const FlattenInput& input, const Options& options, CutKind kind,
                                       const CutWishes& wishes, const Progress& progress) {
  CutProgress cut_progress(progress);
  const SurfaceToCut to_cut(input, options);
  try {
    const ExactEvaluation exact(to_cut, options, cut_progress.token());
    const FlatPieces pieces = exact.uncut();
    check_wishes(wishes, input, pieces.size());
    return best_cuts(pieces, kind, wishes, exact, cut_progress);
  } catch (const Stopped&) {
    throw FlattenError(ErrorCode::cancelled, ErrorArguments{});
  }
}

}  // namespace

std::vector<DartProposal> propose_darts(const FlattenInput& input, const Options& options, const CutWishes& wishes,
                                        const Progress& progress) {
  return propose_cuts(input, options, CutKind::dart, wishes, progress);
}

std::vector<DartProposal> propose_seams(const FlattenInput& input, const Options& options, const CutWishes& wishes,
                                        const Progress& progress) {
  return propose_cuts(input, options, CutKind::seam, wishes, progress);
}

}  // namespace wirewarp
