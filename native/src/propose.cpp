// SPDX-License-Identifier: GPL-3.0-or-later
#include "cuts/propose/best_cuts.h"
#include "cuts/propose/line_evaluation.h"

namespace wirewarp {
namespace {

std::vector<DartProposal> propose_cuts(const FlattenInput& input, const Options& options, CutKind kind,
                                       const CutOptions& cut_options, const Progress& progress) {
  CutProgress cut_progress(progress);
  std::vector<DartProposal> proposals =
      search_cuts(input, options, cut_progress.token(), [&](const ExactEvaluation& exact) {
        const FlatPieces pieces = exact.uncut();
        check_cut_options(cut_options, input, pieces.size());
        return best_cuts(pieces, kind, cut_options, exact, cut_progress);
      });
  for (DartProposal& proposal : proposals) {
    if (proposal.paths.empty()) proposal.paths = paths_along(input.faces, proposal.edges);
  }
  return proposals;
}

}  // namespace

std::vector<DartProposal> propose_darts(const FlattenInput& input, const Options& options,
                                        const CutOptions& cut_options, const Progress& progress) {
  return propose_cuts(input, options, CutKind::dart, cut_options, progress);
}

std::vector<DartProposal> propose_seams(const FlattenInput& input, const Options& options,
                                        const CutOptions& cut_options, const Progress& progress) {
  return propose_cuts(input, options, CutKind::seam, cut_options, progress);
}

}  // namespace wirewarp
