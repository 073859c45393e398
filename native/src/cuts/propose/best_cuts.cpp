// SPDX-License-Identifier: GPL-3.0-or-later
// Searches one piece after the other for the best cuts of all pieces.
#include "cuts/propose/best_cuts.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include "base/arguments.h"
#include "base/attempt.h"
#include "base/sentence.h"
#include "cuts/propose/cut_sets.h"
#include "cuts/propose/part_sets.h"
#include "cuts/propose/piece_search.h"
#include "cuts/propose/smooth_darts.h"
#include "cuts/propose/smooth_sets.h"
#include "surface/mesh/edge_table.h"
#include "surface/mesh/geometry.h"

namespace wirewarp {
namespace {

/// A piece counts as larger only if its area exceeds the other area by this factor. So rounding errors in rotated input
/// do not decide which piece is larger.
constexpr double kClearlyLarger = 1 + 1e-9;

/// Progress once the sets are found, before they are smoothed. Rough, because it only affects the bar.
constexpr double kSearched = 0.7;

/// Progress once the piece is divided into parts. The division takes the whole time of most searches, but only a
/// quarter of the time if the search continues along edges.
constexpr double kDivided = 0.5;

/// By how much a cut lowers two strains: the largest strain of all pieces, and the strain of the piece that it cuts.
using Gain = std::pair<double, double>;

/// Returns the `count` cuts with the largest gains. A mirrored pair counts as one cut. DartProposal::twin becomes an
/// index into the returned list.
std::vector<DartProposal> best_of(const std::vector<DartProposal>& proposals, const std::vector<Gain>& gains,
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

double strain_of(const FlatPiece& piece) { return piece.error ? -1 : piece.strain; }

/// Returns the gain of a cut that leaves the strain `left` in its piece.
Gain gain_of(const FlatPieces& pieces, int piece, double left) {
  double others = 0;
  for (std::size_t c = 0; c < pieces.size(); ++c) {
    if (static_cast<int>(c) != piece) others = std::max(others, pieces[c]->strain);
  }
  const double before = pieces[piece]->strain;
  return {std::max(before, others) - std::max(left, others), before - left};
}

bool is_second_of_pair(const std::vector<DartProposal>& proposals, std::size_t i) {
  return proposals[i].twin && *proposals[i].twin < static_cast<int>(i);
}

double strain_left(const DartProposal& dart) { return dart.strain_with_twin.value_or(dart.strain); }

/// A dart along edges is added only if it leaves at least this share less strain than the best smooth dart, because its
/// elbows are hard to sew. A smaller difference is not noticeable: of 10% of stretch, it is 0.5%.
constexpr double kWorthElbows = 0.05;

std::vector<DartProposal> with_best_along_edges(std::vector<DartProposal> smooth,
                                                const std::vector<DartProposal>& along_edges) {
  const auto leaves_less = [](const DartProposal& a, const DartProposal& b) { return strain_left(a) < strain_left(b); };
  const auto best = std::min_element(along_edges.begin(), along_edges.end(), leaves_less);
  if (best == along_edges.end()) return smooth;
  const auto best_smooth = std::min_element(smooth.begin(), smooth.end(), leaves_less);
  if (best_smooth != smooth.end() && strain_left(*best) > (1 - kWorthElbows) * strain_left(*best_smooth)) return smooth;
  std::optional<DartProposal> image;
  if (best->twin) image = along_edges[*best->twin];
  add_with_image(*best, std::move(image), {}, smooth);
  return smooth;
}

std::vector<DartProposal> search_piece(const FlatPieces& pieces, int piece, CutKind kind, const CutOptions& cut_options,
                                       const ExactEvaluation& exact) {
  const auto index = static_cast<std::size_t>(piece);
  const PieceSearch search(pieces, index, kind, Effort::thorough, cut_options, exact);
  if (!cut_options.is_smooth || kind != CutKind::dart) return search.search();
  search.check_strain();
  const std::vector<HalfEdgeChain> chains = search.candidates();
  std::vector<DartProposal> darts =
      with_best_along_edges(smooth_darts(search, chains, pieces, index, cut_options, exact), search.best_of(chains));
  if (darts.empty()) throw none_helps(pieces[index]->chart, kind, pieces[index]->strain);
  return darts;
}

/// Searches the pieces for cuts, the most strained piece first. Ends when enough cuts are found, and no cut of the
/// remaining pieces can gain more than these cuts.
std::vector<DartProposal> search_pieces(const FlatPieces& pieces, CutKind kind, const CutOptions& cut_options,
                                        const ExactEvaluation& exact) {
  std::vector<int> order(pieces.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return strain_of(*pieces[a]) > strain_of(*pieces[b]); });
  if (cut_options.piece) order = {*cut_options.piece};
  if (pieces[order.front()]->error) throw exact.explain(pieces, order.front());
  std::vector<DartProposal> proposals;
  std::vector<Gain> gains;
  std::optional<FlattenError> first_refusal;
  for (const int c : order) {
    const Gain most = gain_of(pieces, c, 0);
    int num_better = 0;
    for (std::size_t i = 0; i < gains.size(); ++i) num_better += gains[i] >= most && !is_second_of_pair(proposals, i);
    if (pieces[c]->error || num_better >= cut_options.count) break;
    std::optional<FlattenError> refusal = refusal_of([&] {
      const int first = static_cast<int>(proposals.size());
      for (DartProposal& proposal : search_piece(pieces, c, kind, cut_options, exact)) {
        proposal.piece = c;
        if (proposal.twin) *proposal.twin += first;
        gains.push_back(gain_of(pieces, c, strain_left(proposal)));
        proposals.push_back(std::move(proposal));
      }
    });
    if (!first_refusal) first_refusal = std::move(refusal);
  }
  if (!proposals.empty()) return best_of(proposals, gains, cut_options.count);
  if (!first_refusal) throw std::logic_error("The search of a flat piece returned neither cuts nor an error.");
  throw *first_refusal;
}

/// Returns the index of the largest piece that lacks seams. If a piece is requested, tests only this piece.
std::optional<std::size_t> without_shape(const FlatPieces& pieces, const CutOptions& cut_options) {
  std::optional<std::size_t> largest;
  double most = 0;
  for (std::size_t c = 0; c < pieces.size(); ++c) {
    if (!lacks_seams(*pieces[c]) || cut_options.piece.value_or(static_cast<int>(c)) != static_cast<int>(c)) continue;
    const double area = surface_area(pieces[c]->chart.mesh);
    if (area <= kClearlyLarger * most) continue;
    most = area;
    largest = c;
  }
  return largest;
}

/// Returns cut sets along edges, or smooth sets if cut_options.is_smooth is set. begin: the progress so far.
std::vector<DartProposal> sets_along_edges(const FlatPieces& pieces, std::size_t piece, const CutOptions& cut_options,
                                           const ExactEvaluation& exact, CutProgress& progress, double begin) {
  const double searched = cut_options.is_smooth ? begin + (1 - begin) * kSearched : 1;
  progress.begin_part(begin, searched);
  std::vector<DartProposal> sets = CutSetSearch(pieces, piece, cut_options, exact, progress).search();
  const double share = (1 - searched) / static_cast<double>(sets.size());
  const auto smooth_all = [&] {
    for (std::size_t i = 0; i < sets.size(); ++i) {
      if (!sets[i].paths.empty()) continue;
      progress.begin_part(searched + share * static_cast<double>(i), searched + share * static_cast<double>(i + 1));
      // limit_of_set() ignores an excess below kStrainError.
      const double limit = std::max(limit_of_set(sets[i], cut_options), sets[i].strain);
      DartProposal smooth = smooth_set(sets[i], std::min(limit, kMostStrain), pieces, piece, cut_options, exact);
      if (smooth.strain < kMostStrain && smooth.length <= cut_options.longest) sets[i] = std::move(smooth);
    }
  };
  if (cut_options.is_smooth) was_stopped(smooth_all);  // if canceled, the remaining sets stay along edges
  progress.begin_part(0, 1);
  return sets;
}

/// Returns the cut sets that divide the piece into its parts. If none is easy to sew, adds sets along edges. The search
/// for them takes 2 to 3 times as long as the division, but may save half of the pieces.
std::vector<DartProposal> cut_sets(const FlatPieces& pieces, std::size_t piece, const CutOptions& cut_options,
                                   const ExactEvaluation& exact, CutProgress& progress) {
  if (!cut_options.is_smooth || !can_be_divided(*pieces[piece], exact))
    return sets_along_edges(pieces, piece, cut_options, exact, progress, 0);
  progress.begin_part(0, kDivided);
  PartSets parts;
  try {
    parts = part_sets(pieces, piece, cut_options, exact, progress);
  } catch (const FactorizationFailed&) {
    parts = {};  // the search along edges needs no necks, whose matrix had no factor
  }
  std::vector<DartProposal> sets = std::move(parts.sets);
  if (sets.empty()) return sets_along_edges(pieces, piece, cut_options, exact, progress, kDivided);
  if (!parts.are_sewable) {
    was_stopped([&] {
      refusal_of([&] {
        for (DartProposal& set : sets_along_edges(pieces, piece, cut_options, exact, progress, kDivided))
          sets.push_back(std::move(set));
      });
    });
    sets = without_worse(std::move(sets));
  }
  progress.begin_part(0, 1);
  return chosen_by_limit(sets, cut_options);
}

void check_edges(const std::string& name, const VertexPairs& pairs, const FlattenInput& input, const EdgeTable& edges) {
  for (const auto& ends : pairs.rowwise()) {
    const bool are_vertices = ends.minCoeff() >= 0 && ends.maxCoeff() < input.vertices.rows();
    if (are_vertices && edges.find(ends[0], ends[1]) >= 0) continue;
    throw wrong_option(name, "a list with the pair " + std::to_string(ends[0]) + ", " + std::to_string(ends[1]),
                       "contain edges of the mesh only");
  }
}

}  // namespace

void check_cut_options(const CutOptions& cut_options, const FlattenInput& input, std::size_t num_pieces) {
  if (cut_options.count < 1) throw wrong_option("count", std::to_string(cut_options.count), "be 1 or more");
  if (cut_options.strain && !(*cut_options.strain >= 0))
    throw wrong_option("strain", shortest(*cut_options.strain), "be 0 or more");
  if (!(cut_options.longest > 0)) throw wrong_option("longest", shortest(cut_options.longest), "be above 0");
  if (!(cut_options.narrowest >= 0 && std::isfinite(cut_options.narrowest)))
    throw wrong_option("narrowest", shortest(cut_options.narrowest), "be a finite number of 0 or more");
  if (cut_options.piece && (*cut_options.piece < 0 || *cut_options.piece >= static_cast<int>(num_pieces))) {
    throw wrong_option("piece", std::to_string(*cut_options.piece),
                       "be from 0 to " + std::to_string(num_pieces - 1) + ", as the mesh has " +
                           std::to_string(num_pieces) + (num_pieces == 1 ? " piece" : " pieces"));
  }
  if (cut_options.no_seam.rows() + cut_options.no_crossing.rows() == 0) return;
  const EdgeTable edges(input.faces, static_cast<int>(input.vertices.rows()));
  check_edges("no_seam", cut_options.no_seam, input, edges);
  check_edges("no_crossing", cut_options.no_crossing, input, edges);
}

bool lacks_seams(const FlatPiece& piece) {
  if (!piece.error) return piece.strain >= kMostStrain && !has_wires(piece.chart);
  switch (piece.error->code) {
    case ErrorCode::closed_chart:
    case ErrorCode::handles:
    case ErrorCode::boundary_too_short:
    case ErrorCode::flipped_faces:
    case ErrorCode::overlapping_faces:
      return true;
    case ErrorCode::infeasible_lengths:
      return !has_wires(piece.chart);
    default:
      return false;
  }
}

std::vector<DartProposal> best_cuts(const FlatPieces& pieces, CutKind kind, const CutOptions& cut_options,
                                    const ExactEvaluation& exact, CutProgress& progress) {
  const std::optional<std::size_t> piece = kind == CutKind::seam ? without_shape(pieces, cut_options) : std::nullopt;
  progress.enter(0, 1);
  if (!piece) return search_pieces(pieces, kind, cut_options, exact);
  std::vector<DartProposal> sets = cut_sets(pieces, *piece, cut_options, exact, progress);
  for (DartProposal& set : sets) set.piece = static_cast<int>(*piece);
  return sets;
}

}  // namespace wirewarp
