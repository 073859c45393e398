// SPDX-License-Identifier: GPL-3.0-or-later
// Where to cut: the pieces of the input one after the other, and the best of all their cuts.
#include <algorithm>
#include <atomic>
#include <functional>
#include <numeric>
#include <string>
#include <thread>
#include <utility>

#include "charts/cut_into_charts.h"
#include "errors/sentence.h"
#include "mesh/geometry.h"
#include "middle_surface.h"
#include "progress_report.h"
#include "propose/first_cuts.h"
#include "propose/piece_search.h"
#include "stop_token.h"

namespace wirewarp {
namespace {

/// Of the search in a piece of some thousand triangles: what the fraction of the work is told by, which is not known
/// beforehand.
constexpr int kTypicalQuestions = 2000;

constexpr double kClearlyLarger = 1 + 1e-9;  // larger: the same piece however the mesh is turned

/// In this order, twins by their new places; each pair counts once.
std::vector<DartProposal> best_of(const std::vector<DartProposal>& proposals, const std::vector<double>& gains,
                                  int count) {
  std::vector<int> order(proposals.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return gains[a] > gains[b]; });
  std::vector<int> place(proposals.size(), -1);
  std::vector<DartProposal> best;
  for (const int i : order) {
    const bool is_second = proposals[i].twin && place[*proposals[i].twin] >= 0;
    if (!is_second && count-- <= 0) continue;
    place[i] = static_cast<int>(best.size());
    best.push_back(proposals[i]);
  }
  for (DartProposal& proposal : best) {
    if (proposal.twin) proposal.twin = place[*proposal.twin];
  }
  return best;
}

void check_wishes(const CutWishes& wishes, std::size_t num_pieces, const EdgeTable& edges, Eigen::Index num_vertices) {
  if (wishes.count < 1)
    throw FlattenError(ErrorCode::invalid_option, "count must be 1 or more, not " + std::to_string(wishes.count) + ".");
  if (wishes.strain && !(*wishes.strain >= 0))
    throw FlattenError(ErrorCode::invalid_option, "strain must be 0 or more, not " + shortest(*wishes.strain) + ".");
  if (!(wishes.longest > 0))
    throw FlattenError(ErrorCode::invalid_option, "longest must be above 0, not " + shortest(wishes.longest) + ".");
  if (wishes.piece && (*wishes.piece < 0 || *wishes.piece >= static_cast<int>(num_pieces))) {
    throw FlattenError(ErrorCode::invalid_option, "piece is " + std::to_string(*wishes.piece) +
                                                      ", but pieces are counted from 0, and the mesh has " +
                                                      std::to_string(num_pieces) + ".");
  }
  for (const auto& ends : wishes.no_seam.rowwise()) {
    const bool are_vertices = ends.minCoeff() >= 0 && ends.maxCoeff() < num_vertices;
    if (are_vertices && edges.find(ends[0], ends[1]) >= 0) continue;
    throw FlattenError(ErrorCode::invalid_option, "no_seam has the pair " + std::to_string(ends[0]) + ", " +
                                                      std::to_string(ends[1]) + ", which is no edge of the mesh.");
  }
}

/// How much distortion a piece has; none that does not lie flat.
double total_energy(const PieceFigures& figures) { return figures.error ? -1 : figures.energy * figures.area; }

int most_distorted(const std::vector<PieceFigures>& before) {
  const auto has_less = [](const PieceFigures& a, const PieceFigures& b) { return total_energy(a) < total_energy(b); };
  return static_cast<int>(std::max_element(before.begin(), before.end(), has_less) - before.begin());
}

/// Searches the pieces, the most distorted one first, until the rest have less to gain than what is found.
std::vector<DartProposal> search_pieces(const std::vector<Chart>& charts, const std::vector<PieceFigures>& before,
                                        CutKind kind, const CutWishes& wishes, FullTrials& trials,
                                        const std::function<bool()>& go_on) {
  std::vector<int> order(charts.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return total_energy(before[a]) > total_energy(before[b]); });
  if (wishes.piece) order = {*wishes.piece};
  std::vector<DartProposal> proposals;
  std::vector<double> gains;
  std::optional<FlattenError> first_refusal;
  for (const int c : order) {
    const auto gain_more =
        std::count_if(gains.begin(), gains.end(), [&](double gain) { return gain >= total_energy(before[c]); });
    if (before[c].error || gain_more >= 2 * wishes.count) break;  // twins counted
    try {
      const int first = static_cast<int>(proposals.size());
      for (DartProposal& proposal :
           PieceSearch(charts[c], kind, Effort::thorough, wishes, trials, go_on).search(before[c])) {
        proposal.piece = c;
        if (proposal.twin) *proposal.twin += first;
        gains.push_back((proposal.energy_before - proposal.energy) * before[c].area);
        proposals.push_back(std::move(proposal));
      }
    } catch (const FlattenError& error) {
      if (error.code != ErrorCode::no_proposal) throw;
      if (!first_refusal) first_refusal = error;
    }
  }
  if (proposals.empty()) throw *first_refusal;
  return best_of(proposals, gains, wishes.count);
}

/// The piece to cut, if it has no flat shape for want of seams; of all pieces the largest of these.
std::optional<int> without_shape(const std::vector<Chart>& charts, const std::vector<PieceFigures>& before,
                                 const CutWishes& wishes) {
  std::optional<int> largest;
  double most = 0;
  for (int c = 0; c < static_cast<int>(charts.size()); ++c) {
    if (!before[c].error || !lacks_seams(charts[c], *before[c].error) || wishes.piece.value_or(c) != c) continue;
    const double area = surface_area(charts[c].mesh);
    if (area <= kClearlyLarger * most) continue;
    most = area;
    largest = c;
  }
  return largest;
}

std::vector<DartProposal> propose_cuts(const FlattenInput& input, const Options& options, CutKind kind,
                                       const CutWishes& wishes, const Progress& progress) {
  ProgressReport report(progress);
  const std::thread::id caller = std::this_thread::get_id();
  std::atomic<int> questions{0};
  const std::function<bool()> go_on = [&] {
    const int asked = questions++;
    if (std::this_thread::get_id() != caller) return !report.is_cancelled();
    return report.go_on("cuts", static_cast<double>(asked) / (asked + kTypicalQuestions));
  };
  try {
    FullTrials trials(input, options, go_on);
    const FlattenResult uncut = trials.run({});
    const EdgeTable edges(input.faces, static_cast<int>(input.vertices.rows()));
    check_wishes(wishes, uncut.pieces.size(), edges, input.vertices.rows());
    const FlattenInput flattened = options.thickness > 0 ? move_to_middle(input, options) : input;
    const std::vector<Chart> charts = cut_into_charts(flattened, edges).charts;
    std::vector<PieceFigures> before;
    for (const Chart& chart : charts) before.push_back(figures_of(uncut, chart, options));
    if (kind == CutKind::seam) {
      if (const std::optional<int> piece = without_shape(charts, before, wishes)) {
        std::vector<DartProposal> sets = FirstCuts(flattened, charts[*piece], wishes, trials, go_on).search();
        for (DartProposal& set : sets) set.piece = *piece;
        return sets;
      }
    }
    const int first = wishes.piece.value_or(most_distorted(before));
    if (before[first].error) throw *flatten(input, options, progress).pieces[first].error;  // with what mends it
    return search_pieces(charts, before, kind, wishes, trials, go_on);
  } catch (const Stopped&) {
    throw FlattenError(ErrorCode::cancelled, "Cancelled before all cuts were tried.");
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
