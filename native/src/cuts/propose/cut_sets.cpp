// SPDX-License-Identifier: GPL-3.0-or-later
#include "cuts/propose/cut_sets.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>
#include <utility>

#include "base/attempt.h"
#include "base/in_threads.h"
#include "cuts/feasibility/bisect.h"
#include "cuts/feasibility/open_chart.h"
#include "cuts/propose/canonical_order.h"
#include "cuts/propose/coarse_evaluation.h"
#include "cuts/propose/cut_chains.h"
#include "cuts/propose/flat_width.h"
#include "cuts/propose/merge_sections.h"
#include "cuts/propose/merge_smooth.h"
#include "cuts/propose/mirror_image.h"
#include "cuts/propose/piece_search.h"
#include "newton/refine_chart.h"

namespace wirewarp {
namespace {

/// Limits of one call of cut_once_more():
/// - kPlaces: number of seams, and number of darts, that are candidates; the second is needed if the first fails
/// - kMostTrials: number of exact evaluations; one was enough in each of forty calls for a koala
constexpr int kPlaces = 2;
constexpr std::size_t kMostTrials = 5;

/// A cut is worth sewing if it removes at least this share of its part's energy. A set is listed if its strain is lower
/// than the strain of a shorter set by more than this share. Smaller gains cannot be felt: 2% of 25% is 0.5%, as
/// kMayStay.
constexpr double kWorthSewing = 0.02;

/// Lower strains count as this strain, because ratios of such strains are meaningless: 0.1 mm in a piece of 1 m.
constexpr double kFlat = 1e-4;

/// kOpened: progress when all parts have a flat shape. kCut: progress when the last cut is added. Both were measured on
/// models of a cow and a penguin.
constexpr double kOpened = 0.1, kCut = 0.5;

/// - kStrainStep: ratio of consecutive strains for which sets are merged; by default, these strains are 5%, 10% and 20%
/// - kMergedSets: largest number of merged sets; without it, low targets would have more
constexpr double kStrainStep = 2;
constexpr std::size_t kMergedSets = 3;

/// Pieces are merged up to this share of the allowed strain, because smoothing their new corners adds strain. With
/// 0.95, most corners of a whale remained.
constexpr double kMergeShare = 0.85;

/// Cuts that remove at least this share of the energy are tried first, because small darts are slow to sew. With 0.5
/// instead of 0, the search takes two thirds of the time, but sets are 10% longer.
constexpr double kLargeGain = 0.25;

/// Least solidity of a joined piece. With 0, arms, ears and half a body of a rabbit become one piece. With 0.6, a bear
/// has 11 pieces instead of 8, and a koala 22 instead of 12.
constexpr double kLeastSolidity = 0.45;

FlattenError none_found(const Chart& chart, const CutOptions& cut_options) {
  return no_proposal(chart, {{"reason", "no_set"}, {"is_restricted", cut_options.no_seam.rows() > 0}});
}

}  // namespace

std::vector<double> allowed_strains(double least, double target) {
  const double most = std::max(kSoftStrain, kStrainStep * target);
  std::vector<double> allowed{least};
  while (allowed.size() < kMergedSets && allowed.back() * std::sqrt(kStrainStep) < most)
    allowed.push_back(allowed.back() * kStrainStep);
  return allowed;
}

std::vector<DartProposal> without_worse(std::vector<DartProposal> sets) {
  std::stable_sort(sets.begin(), sets.end(),
                   [](const DartProposal& a, const DartProposal& b) { return a.length > b.length; });
  const auto is_worse = [](const DartProposal& set, const DartProposal& other) {
    return set.num_pieces >= other.num_pieces && set.strain >= other.strain;
  };
  std::vector<DartProposal> kept;
  for (auto set = sets.begin(); set != sets.end(); ++set) {
    if (std::none_of(set + 1, sets.end(), [&](const DartProposal& shorter) { return is_worse(*set, shorter); }))
      kept.push_back(*set);
  }
  return kept;
}

double limit_of_set(const DartProposal& set, const CutOptions& cut_options) {
  double allowed = std::max(cut_options.strain.value_or(kTargetStrain), kFlat);
  while (set.strain - allowed > kStrainError) allowed *= kStrainStep;
  return allowed;
}

std::vector<DartProposal> chosen_by_limit(const std::vector<DartProposal>& sets, const CutOptions& cut_options) {
  std::vector<double> limits;
  for (const DartProposal& set : sets) limits.push_back(limit_of_set(set, cut_options));
  std::vector<std::size_t> order, others;
  for (std::size_t i = 0; i < sets.size(); ++i) {
    const auto next = limits.begin() + static_cast<std::ptrdiff_t>(i) + 1;
    const bool is_shortest = std::find(next, limits.end(), limits[i]) == limits.end();
    (i == 0 || is_shortest ? order : others).push_back(i);
  }
  order.insert(order.end(), others.begin(), others.end());
  order.resize(std::min(order.size(), static_cast<std::size_t>(cut_options.count)));
  std::sort(order.begin(), order.end());
  std::vector<DartProposal> chosen;
  for (const std::size_t i : order) chosen.push_back(sets[i]);
  return chosen;
}

CutSetSearch::CutSetSearch(const FlatPieces& pieces, std::size_t piece, const CutOptions& cut_options,
                           const ExactEvaluation& exact, CutProgress& progress, const MostCuts& most_cuts)
    : pieces_(pieces),
      piece_(piece),
      input_chart_(pieces[piece]->chart),
      is_flat_(!pieces[piece]->error),
      chart_(in_canonical_order(input_chart_, exact.stop())),
      map_(chart_),
      image_(mirror_image(chart_, exact.stop())),
      mirrored_(chart_, image_),
      forbidden_(mirrored_.with_image(map_.mask_of(as_list(cut_options.no_seam)))),
      cut_options_(cut_options),
      target_(cut_options.strain.value_or(kTargetStrain)),
      fine_(cut_options.is_smooth && cut_options.strain ? target_ / kFineGrowth : target_),
      exact_(exact),
      progress_(progress),
      most_cuts_(most_cuts) {
  mirrored_.forbid_edges_without_image(forbidden_);
}

CutMask CutSetSearch::opening() const {
  const auto lies_flat_alone = [&](const Chart& part) { return lies_flat(part, exact_.options(), exact_.stop()); };
  CutMask cut = open_chart(chart_, lies_flat_alone, exact_.stop(), {forbidden_, image_});
  exact_.stop().check();
  return cut;
}

CutSetSearch::CutSet CutSetSearch::with_figures(CutMask cut, FlatPieces pieces) const {
  const PieceFigures figures = figures_of(pieces, input_chart_);
  CutSet set{std::move(cut), std::move(pieces), {}, !figures.error};
  DartProposal& proposal = set.proposal;
  proposal.edges = edges_by_section(chart_, set.cut);
  proposal.length = length_of_cut(chart_.mesh, set.cut);
  proposal.num_pieces = figures.num_pieces;
  proposal.energy = figures.energy;
  proposal.strain = figures.strain;
  proposal.energy_before = proposal.strain_before = std::numeric_limits<double>::infinity();
  return set;
}

/// before: pieces that are already cut along some edges of the cut.
CutSetSearch::CutSet CutSetSearch::evaluate(const FlatPieces& before, const CutMask& cut) const {
  return with_figures(cut, exact_.with_cut(before, edges_by_section(chart_, cut)));
}

/// Returns the index in set.pieces of the most strained part of the piece.
std::size_t CutSetSearch::worst_part(const CutSet& set) const {
  const auto strain = [&](const auto& piece) { return is_part_of(piece->chart, input_chart_) ? piece->strain : -1; };
  const auto has_less = [&](const auto& a, const auto& b) { return strain(a) < strain(b); };
  const auto worst = std::max_element(set.pieces.begin(), set.pieces.end(), has_less);
  return static_cast<std::size_t>(worst - set.pieces.begin());
}

/// Adds darts and seams of one part as candidates. part: index in set.pieces.
void CutSetSearch::add_lines(const CutSet& set, std::size_t part, std::vector<Candidate>& found) const {
  CutOptions cut_options;
  cut_options.count = kPlaces;
  cut_options.strain = fine_;
  cut_options.longest = cut_options_.longest - set.proposal.length;
  cut_options.no_seam = as_pairs(edges_by_section(chart_, forbidden_));
  for (const CutKind kind : {CutKind::seam, CutKind::dart}) {
    refusal_of([&] {
      PieceSearch search(set.pieces, part, kind, Effort::quick, cut_options, exact_);
      for (const DartProposal& cut : search.search()) {
        const double gain = 1 - cut.energy / cut.energy_before;
        found.push_back({mirrored_.with_image(map_.mask_of(cut.edges)), gain, gain / cut.length});
      }
    });
  }
}

/// Adds bisections of one part as candidates, because they help if no single line helps. part: index in set.pieces.
void CutSetSearch::add_bisections(const CutSet& set, std::size_t part, std::vector<Candidate>& found) const {
  const Chart& chart = set.pieces[part]->chart;
  const CoarseEvaluation trials(chart, exact_.options(), exact_.stop());
  const std::vector<CutMask> bisections = bisections_of(chart);
  std::vector<Candidate> tried(bisections.size());
  run_on_all_cores(bisections.size(), exact_.stop(), [&](std::size_t i) {
    const CutMask own = map_.on_part(chart, bisections[i]);
    const double cut = trials.energy_when_cut(own, exact_.stop()), uncut = trials.energy_uncut();
    // An energy is infinite if the coarse shape folds. If both energies are infinite, only an exact evaluation can
    // measure the gain.
    const double gain = std::isinf(uncut) && std::isinf(cut) ? kWorthSewing : 1 - cut / uncut;
    tried[i] = {bisections[i], gain, gain / length_of_cut(chart.mesh, own)};
  });
  std::copy_if(tried.begin(), tried.end(), std::back_inserter(found),
               [](const Candidate& candidate) { return candidate.gain >= kWorthSewing; });
}

std::vector<CutMask> CutSetSearch::bisections_of(const Chart& part) const {
  const Chart ordered = in_canonical_order(part, exact_.stop());
  std::vector<CutMask> cuts;
  for (const CutMask& drawn : bisections(ordered.mesh, map_.on_part(ordered, forbidden_))) {
    for (const CutMask& cut : mirrored_.both_ways(map_.on_chart(ordered, drawn))) {
      CutMask symmetric = mirrored_.with_image(cut);
      const bool is_known = std::find(cuts.begin(), cuts.end(), symmetric) != cuts.end();
      if (!is_known && !is_empty(map_.on_part(part, symmetric))) cuts.push_back(std::move(symmetric));
    }
  }
  return cuts;
}

bool CutSetSearch::makes_narrow(const CutSet& more, const FlatPiece& part) const {
  const double narrowest = cut_options_.narrowest;
  return !is_narrow(part, narrowest) && std::any_of(more.pieces.begin(), more.pieces.end(), [&](const auto& piece) {
    return is_part_of(piece->chart, part.chart) && is_narrow(*piece, narrowest);
  });
}

/// Returns the set with one more cut of its worst part; nullopt if no cut helps. Prefers cuts that make no narrow
/// pieces.
std::optional<CutSetSearch::CutSet> CutSetSearch::cut_once_more(const CutSet& set) const {
  const std::size_t worst = worst_part(set);
  const FlatPiece& part = *set.pieces[worst];
  std::vector<Candidate> candidates;
  add_lines(set, worst, candidates);
  add_bisections(set, worst, candidates);
  const auto is_better = [](const Candidate& a, const Candidate& b) {
    const bool a_is_large = a.gain >= kLargeGain, b_is_large = b.gain >= kLargeGain;
    return a_is_large != b_is_large ? a_is_large : a.gain_for_length > b.gain_for_length;
  };
  std::stable_sort(candidates.begin(), candidates.end(), is_better);
  std::vector<CutMask> tried;
  std::optional<CutSet> narrow;
  for (const Candidate& candidate : candidates) {
    if (tried.size() == kMostTrials) break;
    CutMask cut = set.cut;
    unite(cut, candidate.cut);
    const bool is_known = std::find(tried.begin(), tried.end(), cut) != tried.end();
    if (is_known || length_of_cut(chart_.mesh, cut) > cut_options_.longest) continue;
    tried.push_back(cut);
    CutSet more = evaluate(set.pieces, cut);
    // Compares energies, because the strain may rise: the parts together have more outline with fixed lengths.
    const double before = part.energy / part.area, after = figures_of(more.pieces, part.chart).energy;
    if (!more.lies_flat || after > (1 - kWorthSewing) * before) continue;
    if (!makes_narrow(more, part)) return more;
    if (!narrow) narrow = std::move(more);
  }
  return narrow;
}

/// Returns the sets to propose, the longest first. sets: the shortest first.
std::vector<DartProposal> CutSetSearch::best_of(const std::vector<CutSet>& sets) const {
  std::vector<DartProposal> best;
  for (const CutSet& set : sets) {
    if (!best.empty() && best.back().strain <= target_) break;  // longer sets are unnecessary
    const double strain = set.proposal.strain;
    const bool meets_target = !best.empty() && strain <= target_ && best.back().strain > target_;
    // Drops sets that are hardly better than a shorter set.
    if (!best.empty() && !meets_target && strain > (1 - kWorthSewing) * best.back().strain) continue;
    const auto has_needless_pieces = [&](const DartProposal& shorter) {
      return shorter.num_pieces > set.proposal.num_pieces;
    };
    best.erase(std::remove_if(best.begin(), best.end(), has_needless_pieces), best.end());
    best.push_back(set.proposal);
  }
  std::reverse(best.begin(), best.end());
  return chosen_by_limit(best, cut_options_);
}

/// Adds sets with one more cut each, until the last set is fine enough. Throws Stopped. Sets added by then remain.
void CutSetSearch::add_more_cuts(std::vector<CutSet>& sets) {
  const double limit = cut_options_.strain ? fine_ : kSoftStrain;
  const auto most = [&] { return sets.back().proposal.strain > limit ? most_cuts_.in_all : most_cuts_.for_plush; };
  while (sets.size() <= most() && sets.back().proposal.strain > fine_) {
    report_strain(sets.front().proposal.strain, sets.back().proposal.strain);
    std::optional<CutSet> more = cut_once_more(sets.back());
    if (!more) break;
    sets.push_back(std::move(*more));
  }
}

/// Adds sets with fewer sections than the last set: first for the strain of the last set or the target, whichever is
/// larger, then for higher strains. Throws Stopped. Sets added by then remain.
void CutSetSearch::add_merged(std::vector<CutSet>& sets) {
  const MergeRules rules{cut_options_.narrowest, kLeastSolidity};
  SectionMerger merger({sets.back().cut, sets.back().pieces}, chart_, mirrored_, exact_, rules);
  const std::vector<double> allowed = allowed_strains(std::max(target_, sets.back().proposal.strain), target_);
  for (std::size_t i = 0; i < allowed.size(); ++i) {
    const bool stopped = was_stopped([&] {
      merger.run(allowed[i], [&](double share) { report_merged(static_cast<double>(i) + share, allowed.size()); });
    });
    sets.push_back(with_figures(merger.state().cut, merger.state().pieces));
    if (stopped) throw Stopped();
  }
}

/// Adds sets with smooth lines and fewer sections than the last set. Returns false, and leaves the original set last,
/// if lines cannot be smooth or need too much strain. Throws Stopped; added sets remain.
bool CutSetSearch::add_smooth(std::vector<CutSet>& sets) {
  const CutSet fine = sets.back();
  double least = std::max(fine_, kFlat);
  while (least * kStrainStep <= fine.proposal.strain) least *= kStrainStep;
  const PieceToCut piece{pieces_, piece_, chart_, image_};
  SmoothMerger merger(piece, {cut_options_.narrowest, kLeastSolidity}, cut_options_, exact_);
  if (!merger.start(fine.proposal, fine.cut, least)) return false;
  std::vector<double> allowed = allowed_strains(std::max(least, target_), target_);
  // Without this first step, a hand has 8 pieces instead of 6 for 8%, and a penguin 17 instead of 16.
  if (least < target_) allowed.insert(allowed.begin(), least);
  allowed.push_back(allowed.back());
  for (std::size_t i = 0; i < allowed.size(); ++i) {
    const bool is_last = i + 1 == allowed.size();
    // Without the last merge up to the whole strain, a penguin has two more pieces.
    const bool stopped = !merger.merge(is_last ? 1 : kMergeShare, allowed[i], [&](double share) {
      report_merged(static_cast<double>(i) + share, allowed.size());
    });
    if (i == 0) {
      const auto has_more = [&](const CutSet& set) { return set.proposal.num_pieces > merger.set().num_pieces; };
      sets.erase(std::remove_if(sets.begin(), sets.end(), has_more), sets.end());
    }
    sets.emplace_back().proposal = merger.set();
    if (stopped) throw Stopped();
    const DartProposal smooth = merger.smooth(allowed[i]);
    sets.back().proposal = smooth;
    if (is_last) break;
    const bool may_have_more = allowed[i + 1] > allowed[i];
    merger.go_on(may_have_more ? merger.smooth(allowed[i + 1]) : smooth);
  }
  if (sets.back().proposal.strain <= allowed.back() + kStrainError) return true;
  sets.push_back(fine);  // add_merged() merges the pieces of this set along edges
  return false;
}

/// Reports progress on a logarithmic scale, because each cut lowers the strain by about the same ratio.
void CutSetSearch::report_strain(double first, double now) {
  const double least = std::max(fine_, kFlat);
  const double share = first > least ? std::clamp(std::log(first / now) / std::log(first / least), 0.0, 1.0) : 1;
  progress_.stay_at(kOpened + (kCut - kOpened) * share);
}

/// num_done: number of merged sets out of `count`, with a fraction for the set that is being merged.
void CutSetSearch::report_merged(double num_done, std::size_t count) {
  progress_.stay_at(kCut + (1 - kCut) * num_done / static_cast<double>(count));
}

std::vector<DartProposal> CutSetSearch::search() {
  progress_.enter(0, kOpened);
  const CutMask opened = is_flat_ ? CutMask(chart_.mesh.n_edges(), 0) : opening();
  if (is_empty(opened) && !is_flat_) throw none_found(input_chart_, cut_options_);
  std::vector<CutSet> sets{evaluate(pieces_, opened)};
  const DartProposal& least = sets.front().proposal;
  if (!sets.front().lies_flat) throw none_found(input_chart_, cut_options_);
  if (least.length > cut_options_.longest)
    throw no_proposal(input_chart_,
                      {{"reason", "too_long"}, {"length", least.length}, {"limit", cut_options_.longest}});
  const bool stopped = was_stopped([&] {
    add_more_cuts(sets);
    if (!cut_options_.is_smooth || !add_smooth(sets)) add_merged(sets);
  });
  const auto is_too_strained = [](const CutSet& set) { return set.proposal.strain >= kMostStrain; };
  sets.erase(std::remove_if(sets.begin(), sets.end(), is_too_strained), sets.end());
  if (sets.empty() && stopped) throw Stopped();
  if (sets.empty()) throw no_proposal(input_chart_, {{"reason", "too_strained"}});
  std::stable_sort(sets.begin(), sets.end(),
                   [](const CutSet& a, const CutSet& b) { return a.proposal.length < b.proposal.length; });
  return best_of(sets);
}

}  // namespace wirewarp
