// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts to be taken together, towards an aim in numbers: with the best of each round the next one begins.
#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "charts/cut_into_charts.h"
#include "errors/sentence.h"
#include "mesh/edge_table.h"
#include "middle_surface.h"
#include "progress_report.h"
#include "propose/full_trial.h"
#include "stop_token.h"
#include "wirewarp/propose.h"

namespace wirewarp {
namespace {

using ProposeCuts = decltype(&propose_darts);

class PlanOfCuts {
 public:
  PlanOfCuts(const FlattenInput& input, const Options& options, ProposeCuts propose, const CutAim& aim,
             const Progress& progress)
      : input_(input), options_(options), propose_(propose), aim_(aim), report_(progress), pieces_({aim.piece}) {}

  std::vector<DartProposal> make() {
    while (num_left() > 0 && (cuts_.empty() || length_left() > 0)) {
      const std::vector<DartProposal> proposals = propose_next();
      if (proposals.empty()) break;
      take(best_of_round(proposals), proposals);
    }
    return std::move(cuts_);
  }

 private:
  int num_left() const { return aim_.most - static_cast<int>(cuts_.size()); }

  double length_left() const {
    double left = aim_.total_length;
    for (const DartProposal& cut : cuts_) left -= cut.length;
    return left;
  }

  /// fraction: of the round.
  bool tell(const std::string& stage, double fraction) {
    told_ = std::max(told_, (static_cast<double>(cuts_.size()) + fraction) / aim_.most);  // a round may begin anew
    return report_.go_on(stage, told_);
  }

  /// Empty where there are cuts, and no further one helps.
  std::vector<DartProposal> propose_next() {
    CutWishes wishes;
    wishes.strain = aim_.strain;
    wishes.longest = std::min(aim_.longest, length_left());
    wishes.no_seam = aim_.no_seam;
    for (const std::optional<int>& piece : pieces_) {
      wishes.piece = piece;
      try {
        return propose_(input_, options_, wishes,
                        [this](const std::string& stage, double fraction) { return tell(stage, fraction); });
      } catch (const FlattenError& error) {
        if (error.code != ErrorCode::no_proposal || cuts_.empty()) throw;
      }
    }
    return {};
  }

  bool comes_with_twin(const DartProposal& cut, const std::vector<DartProposal>& proposals) const {
    return aim_.twins && cut.strain_with_twin && *cut.strain_with_twin < cut.strain && num_left() >= 2 &&
           cut.length + proposals[*cut.twin].length <= length_left();
  }

  /// Of the piece with most strain.
  const DartProposal& best_of_round(const std::vector<DartProposal>& proposals) const {
    const auto strain = [&](const DartProposal& cut) {
      return comes_with_twin(cut, proposals) ? *cut.strain_with_twin : cut.strain;
    };
    const auto comes_first = [&](const DartProposal& a, const DartProposal& b) {
      return a.strain_before == b.strain_before ? strain(a) < strain(b) : a.strain_before > b.strain_before;
    };
    return *std::min_element(proposals.begin(), proposals.end(), comes_first);
  }

  void take(const DartProposal& best, const std::vector<DartProposal>& proposals) {
    if (aim_.piece && cuts_.empty()) faces_ = charts_of(input_)[*aim_.piece].source_face;
    std::vector<DartProposal> taken{best};
    if (comes_with_twin(best, proposals)) {
      taken.push_back(proposals[*best.twin]);
      const int first = static_cast<int>(cuts_.size());
      taken[0].twin = first + 1;
      taken[1].twin = first;
    } else {
      taken[0].twin.reset();
      taken[0].energy_with_twin.reset();
      taken[0].strain_with_twin.reset();
    }
    for (const DartProposal& cut : taken) input_ = with_seams(std::move(input_), cut.edges);
    const double strain_left = measure();
    for (DartProposal& cut : taken) {
      cut.strain_left = strain_left;
      cuts_.push_back(std::move(cut));
    }
  }

  std::vector<Chart> charts_of(const FlattenInput& input) const {
    return cut_into_charts(input, EdgeTable(input.faces, static_cast<int>(input.vertices.rows()))).charts;
  }

  /// Finds what may be cut next, the part with most strain first; returns the strain of that one. Throws Stopped.
  double measure() {
    const std::function<bool()> go_on = [this] { return tell("cuts", 0); };
    const FlattenResult result = FullTrials(input_, options_, go_on).run({});
    const std::vector<Chart> charts = charts_of(options_.thickness > 0 ? move_to_middle(input_, options_) : input_);
    std::vector<std::pair<double, int>> parts;  // strain, piece
    for (int c = 0; c < static_cast<int>(charts.size()); ++c) {
      if (aim_.piece && !std::binary_search(faces_.begin(), faces_.end(), charts[c].source_face.front())) continue;
      const PieceFigures figures = figures_of(result, charts[c], options_);
      if (!figures.error) parts.emplace_back(figures.strain, c);
    }
    std::stable_sort(parts.begin(), parts.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    if (aim_.piece) {
      pieces_.clear();
      for (const auto& part : parts) pieces_.emplace_back(part.second);
    }
    return parts.front().first;
  }

  FlattenInput input_;  // with the cuts that are taken
  const Options& options_;
  const ProposeCuts propose_;
  const CutAim& aim_;
  ProgressReport report_;
  double told_ = 0;
  std::vector<DartProposal> cuts_;
  std::vector<std::optional<int>> pieces_;  // to cut next, in this order
  std::vector<int> faces_;                  // of the piece asked for, sorted
};

std::vector<DartProposal> plan(const FlattenInput& input, const Options& options, ProposeCuts propose,
                               const CutAim& aim, const Progress& progress) {
  if (aim.most < 1)
    throw FlattenError(ErrorCode::invalid_option, "most must be at least 1, not " + std::to_string(aim.most) + ".");
  if (!(aim.total_length > 0)) {
    throw FlattenError(ErrorCode::invalid_option,
                       "total_length must be above 0, not " + shortest(aim.total_length) + ".");
  }
  try {
    return PlanOfCuts(input, options, propose, aim, progress).make();
  } catch (const Stopped&) {
    throw FlattenError(ErrorCode::cancelled, "Cancelled before all cuts were tried.");
  }
}

}  // namespace

std::vector<DartProposal> plan_darts(const FlattenInput& input, const Options& options, const CutAim& aim,
                                     const Progress& progress) {
  return plan(input, options, propose_darts, aim, progress);
}

std::vector<DartProposal> plan_seams(const FlattenInput& input, const Options& options, const CutAim& aim,
                                     const Progress& progress) {
  return plan(input, options, propose_seams, aim, progress);
}

}  // namespace wirewarp
