// SPDX-License-Identifier: GPL-3.0-or-later
// Plans several cuts to reach a target: each round adds the best cut to the cuts of earlier rounds.
#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "base/arguments.h"
#include "base/sentence.h"
#include "cuts/propose/best_cuts.h"
#include "cuts/propose/line_evaluation.h"
#include "cuts/propose/piece_search.h"
#include "surface/mesh/geometry.h"

namespace wirewarp {
namespace {

CutOptions options_within(const CutTarget& target, double longest) {
  CutOptions cut_options;
  cut_options.piece = target.piece;
  cut_options.strain = target.strain;
  cut_options.longest = longest;
  cut_options.no_seam = target.no_seam;
  return cut_options;
}

class PlanOfCuts {
 public:
  PlanOfCuts(const FlatPieces& pieces, CutKind kind, const CutTarget& target, const ExactEvaluation& exact,
             CutProgress& progress)
      : pieces_(pieces), kind_(kind), target_(target), exact_(exact), progress_(progress) {
    if (target.piece) requested_ = pieces[*target.piece];
  }

  std::vector<DartProposal> make() {
    while (num_left() > 0 && (cuts_.empty() || length_left() > 0)) {
      const std::vector<DartProposal> proposals = propose_next();
      if (proposals.empty()) break;
      take(best_of_round(proposals), proposals);
    }
    return std::move(cuts_);
  }

 private:
  int num_left() const { return target_.most - static_cast<int>(cuts_.size()); }

  double length_left() const {
    double left = target_.total_length;
    for (const DartProposal& cut : cuts_) left -= cut.length;
    return left;
  }

  bool may_be_cut(const FlatPiece& piece) const { return !requested_ || is_part_of(piece.chart, requested_->chart); }

  /// Returns the pieces to try. If seams are planned, pieces that lack seams come first, the largest first. The other
  /// pieces follow, the most strained first, because only cuts of the most strained piece lower the largest strain.
  std::vector<int> pieces_in_order() const {
    std::vector<std::tuple<bool, double, int>> places;  // false if it lacks seams; negative area or strain; index
    for (int i = 0; i < static_cast<int>(pieces_.size()); ++i) {
      const FlatPiece& piece = *pieces_[i];
      if (!may_be_cut(piece)) continue;
      const bool is_open = kind_ == CutKind::seam && lacks_seams(piece);
      if (!piece.error || is_open)
        places.emplace_back(!is_open, is_open ? -surface_area(piece.chart.mesh) : -piece.strain, i);
    }
    std::sort(places.begin(), places.end());
    std::vector<int> order;
    for (const auto& place : places) order.push_back(std::get<int>(place));
    return order;
  }

  /// Returns the best cuts of the current pieces. If canceled, throws Stopped instead of returning a partial result,
  /// because a step of a plan must not depend on the moment of cancellation.
  std::vector<DartProposal> propose(const CutOptions& cut_options) const {
    std::vector<DartProposal> proposals = best_cuts(pieces_, kind_, cut_options, exact_, progress_);
    exact_.stop().check();
    return proposals;
  }

  /// Returns the proposals for the first piece that a cut helps; empty if no cut helps and the plan already has cuts.
  std::vector<DartProposal> propose_next() const {
    CutOptions cut_options = options_within(target_, std::min(target_.longest, length_left()));
    const std::vector<int> order = pieces_in_order();
    if (order.empty() && cuts_.empty()) return propose(cut_options);  // throws: no piece can be cut
    std::optional<FlattenError> first_refusal;
    for (const int piece : order) {
      cut_options.piece = piece;
      std::vector<DartProposal> proposals;
      std::optional<FlattenError> refusal = refusal_of([&] { proposals = propose(cut_options); });
      if (!refusal && helps(best_of_round(proposals), proposals)) return proposals;
      if (!refusal) refusal = none_helps(pieces_[piece]->chart, kind_, pieces_[piece]->strain);
      if (!first_refusal) first_refusal = std::move(refusal);
    }
    if (cuts_.empty()) throw *first_refusal;
    return {};
  }

  bool comes_with_mirror_image(const DartProposal& cut, const std::vector<DartProposal>& proposals) const {
    return target_.twins && cut.strain_with_twin && *cut.strain_with_twin < cut.strain && num_left() >= 2 &&
           cut.length + proposals[*cut.twin].length <= length_left();
  }

  double strain_if_taken(const DartProposal& cut, const std::vector<DartProposal>& proposals) const {
    return comes_with_mirror_image(cut, proposals) ? *cut.strain_with_twin : cut.strain;
  }

  bool helps(const DartProposal& cut, const std::vector<DartProposal>& proposals) const {
    return strain_if_taken(cut, proposals) < cut.strain_before;
  }

  const DartProposal& best_of_round(const std::vector<DartProposal>& proposals) const {
    return *std::min_element(proposals.begin(), proposals.end(), [&](const DartProposal& a, const DartProposal& b) {
      return strain_if_taken(a, proposals) < strain_if_taken(b, proposals);
    });
  }

  void take(const DartProposal& best, const std::vector<DartProposal>& proposals) {
    std::vector<DartProposal> taken{best};
    if (comes_with_mirror_image(best, proposals)) {
      taken.push_back(proposals[*best.twin]);
      const int first = static_cast<int>(cuts_.size());
      taken[0].twin = first + 1;
      taken[1].twin = first;
    } else {
      taken[0].twin.reset();
      taken[0].energy_with_twin.reset();
      taken[0].strain_with_twin.reset();
    }
    std::vector<VertexPair> edges;
    for (const DartProposal& cut : taken) edges.insert(edges.end(), cut.edges.begin(), cut.edges.end());
    pieces_ = exact_.with_cut(pieces_, edges);
    const double strain_left = most_strain_left();
    for (DartProposal& cut : taken) {
      cut.strain_left = strain_left;
      cuts_.push_back(std::move(cut));
    }
    progress_.finish_rounds(static_cast<int>(cuts_.size()));
  }

  double most_strain_left() const {
    double most = -1;
    for (const auto& piece : pieces_) {
      if (!piece->error && may_be_cut(*piece)) most = std::max(most, piece->strain);
    }
    if (most < 0) throw std::logic_error("A cut was made that leaves no part with a flat shape.");
    return most;
  }

  FlatPieces pieces_;  // pieces with all cuts so far
  const CutKind kind_;
  const CutTarget& target_;
  const ExactEvaluation& exact_;
  CutProgress& progress_;
  std::shared_ptr<const FlatPiece> requested_;  // the requested piece before any cut
  std::vector<DartProposal> cuts_;
};

std::vector<DartProposal> plan(const FlattenInput& input, const Options& options, CutKind kind, const CutTarget& target,
                               const Progress& progress) {
  if (target.most < 1) throw wrong_option("most", std::to_string(target.most), "be at least 1");
  if (!(target.total_length > 0)) {
    throw wrong_option("total_length", shortest(target.total_length), "be above 0");
  }
  CutProgress cut_progress(progress, target.most);
  std::vector<DartProposal> cuts = search_cuts(input, options, cut_progress.token(), [&](const ExactEvaluation& exact) {
    const FlatPieces pieces = exact.uncut();
    check_cut_options(options_within(target, target.longest), input, pieces.size());
    return PlanOfCuts(pieces, kind, target, exact, cut_progress).make();
  });
  for (DartProposal& cut : cuts) cut.paths = paths_along(input.faces, cut.edges);
  return cuts;
}

}  // namespace

std::vector<DartProposal> plan_darts(const FlattenInput& input, const Options& options, const CutTarget& target,
                                     const Progress& progress) {
  return plan(input, options, CutKind::dart, target, progress);
}

std::vector<DartProposal> plan_seams(const FlattenInput& input, const Options& options, const CutTarget& target,
                                     const Progress& progress) {
  return plan(input, options, CutKind::seam, target, progress);
}

}  // namespace wirewarp
