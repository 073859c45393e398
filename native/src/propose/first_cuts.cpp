// SPDX-License-Identifier: GPL-3.0-or-later
#include "propose/first_cuts.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>
#include <utility>

#include "charts/cut_into_charts.h"
#include "errors/sentence.h"
#include "feasibility/halve.h"
#include "feasibility/propose_seams.h"
#include "in_threads.h"
#include "propose/canonical_order.h"
#include "propose/cut_chains.h"
#include "propose/cut_trial.h"
#include "propose/mirror_image.h"
#include "propose/piece_search.h"
#include "refine/lies_flat.h"
#include "stop_token.h"

namespace wirewarp {
namespace {

/// What woven cloth takes at most: where nothing else is asked for, pieces with no more are not cut again.
constexpr double kAim = 0.05;

/// Cuts and their mirror images after those that open the piece: two for each of twenty parts, as a plush animal has.
constexpr std::size_t kMostCuts = 40;

/// Of the best cuts, for each kind: what is better beside the others is found out in full. On a koala the first of the
/// candidates served in each of forty rounds.
constexpr int kPlaces = 2;
constexpr std::size_t kMostTrials = 5;

/// A cut that takes less than this share of the energy of its part is not worth the sewing, nor a set whose strain is
/// less by no more.
constexpr double kWorthSewing = 0.02;

/// Strains below are none: of ratios to them nothing can be told.
constexpr double kFlat = 1e-4;

/// Cuts that take this share come before those that take more for their length: many small darts are slow to sew, and
/// slow to find. From 0 to 0.5 the sets of a ball, a head and a penguin have about the same length and strain; with 0.5
/// they are found in two thirds of the time of 0, but are longer by a tenth.
constexpr double kLargeGain = 0.25;

FlattenError no_set(const Chart& chart, const std::string& reason) {
  return FlattenError(ErrorCode::no_proposal, introduce_piece(chart.source_face) + " " + reason,
                      {{}, {}, chart.source_face});
}

FlattenError none_serves(const Chart& chart, const CutWishes& wishes) {
  const std::string along = wishes.no_seam.rows() == 0 ? "" : " along edges that may have a seam";
  return no_set(chart, "does not lie flat, and no set of seams was found" + along +
                           " that lets all of it do so: mark a first seam by hand.");
}

FlattenError too_long(const Chart& chart, double length, double longest) {
  return no_set(chart, "lies flat with seams of " + rounded(length) + " units, and longest is " + rounded(longest) +
                           ": allow more.");
}

VertexPair sorted_ends(VertexPair ends) { return {std::min(ends[0], ends[1]), std::max(ends[0], ends[1])}; }

bool has_face_of(const Chart& chart, const Chart& piece) {
  return std::binary_search(chart.source_face.begin(), chart.source_face.end(), piece.source_face.front());
}

void bar(const VertexPairs& pairs, const std::map<VertexPair, EdgeHandle>& edge_between, CutMask& barred) {
  for (const auto& ends : pairs.rowwise()) {
    const auto found = edge_between.find(sorted_ends({ends[0], ends[1]}));
    if (found != edge_between.end()) barred[found->second.idx()] = 1;
  }
}

}  // namespace

bool lacks_seams(const Chart& chart, const FlattenError& error) {
  switch (error.code) {
    case ErrorCode::closed_chart:
    case ErrorCode::handles:
    case ErrorCode::boundary_too_short:
    case ErrorCode::flipped_faces:
    case ErrorCode::overlapping_faces:
      return true;
    case ErrorCode::infeasible_lengths:
      return !has_wires(chart);
    default:
      return false;
  }
}

FirstCuts::FirstCuts(const FlattenInput& flattened, const Chart& chart, const CutWishes& wishes, FullTrials& trials,
                     const std::function<bool()>& go_on)
    : flattened_(flattened),
      input_chart_(chart),
      chart_(in_canonical_order(chart, go_on)),
      image_(mirror_image(chart_, go_on)),
      mirrored_(chart_, image_),
      wishes_(wishes),
      aim_(wishes.strain.value_or(kAim)),
      trials_(trials),
      go_on_(go_on) {
  for (const EdgeHandle e : chart_.mesh.edges()) {
    if (!chart_.mesh.is_boundary(e)) edge_between_[sorted_ends(ends_in_input(chart_.mesh.halfedge_handle(e, 0)))] = e;
  }
  barred_.assign(chart_.mesh.n_edges(), 0);
  bar(wishes.no_seam, edge_between_, barred_);
  barred_ = mirrored_.with_image(barred_);
  mirrored_.bar_those_without_image(barred_);
}

VertexPair FirstCuts::ends_in_input(HalfedgeHandle h) const {
  const auto input_vertex = [&](VertexHandle v) { return input_chart_.source_vertex[chart_.source_vertex[v.idx()]]; };
  return {input_vertex(chart_.mesh.from_vertex_handle(h)), input_vertex(chart_.mesh.to_vertex_handle(h))};
}

std::vector<VertexPair> FirstCuts::edges_of(const CutMask& cut) const {
  std::vector<VertexPair> edges;
  for (const HalfedgeHandle h : chains_of(chart_.mesh, cut)) edges.push_back(ends_in_input(h));
  return edges;
}

/// Cuts that let the piece lie flat, as far as they were found without its neighbors. Throws Stopped.
CutMask FirstCuts::opening() const {
  const StopToken stop([&](const char*) { return go_on_(); });
  Chart own = chart_;  // with itself as source
  for (const VertexHandle v : own.mesh.vertices()) own.source_vertex[v.idx()] = v.idx();
  const auto lies_flat_alone = [&](const Chart& piece) { return lies_flat(piece, trials_.options(), stop); };
  CutMask cut(chart_.mesh.n_edges(), 0);
  for (const auto& [from, to] :
       propose_seams(own, {lies_flat_alone, [&] { return stop.may_go_on(); }}, {barred_, image_})) {
    const HalfedgeHandle h = chart_.mesh.find_halfedge(VertexHandle(from), VertexHandle(to));
    cut[chart_.mesh.edge_handle(h).idx()] = 1;
  }
  stop.check();
  return cut;
}

FirstCuts::CutSet FirstCuts::flatten(const CutMask& cut) const {
  CutSet set;
  set.cut = cut;
  DartProposal& proposal = set.proposal;
  proposal.edges = edges_of(cut);
  proposal.length = length_of_cut(chart_.mesh, cut);
  trials_.take(proposal.edges);
  const FlattenResult result = trials_.run({});
  const FlattenInput open = with_seams(flattened_, proposal.edges);
  const EdgeTable edges(open.faces, static_cast<int>(open.vertices.rows()));
  set.lies_flat = true;
  double energy = 0, area = 0;
  for (Chart& piece : cut_into_charts(open, edges).charts) {
    if (!has_face_of(input_chart_, piece)) continue;
    const PieceFigures figures = figures_of(result, piece, trials_.options());
    if (figures.error) set.lies_flat = false;
    energy += figures.energy * figures.area;
    area += figures.area;
    proposal.strain = std::max(proposal.strain, figures.strain);
    set.pieces.push_back(std::move(piece));
    set.figures.push_back(figures);
  }
  proposal.energy = energy / area;
  proposal.energy_before = proposal.strain_before = std::numeric_limits<double>::infinity();
  return set;
}

/// Of an edge inside one of its parts.
EdgeHandle FirstCuts::edge_of_chart(const Chart& part, HalfedgeHandle h) const {
  return edge_between_.at(sorted_ends(source_edge(part, h)));
}

/// What of a cut lies inside a part, on the edges of the part.
CutMask FirstCuts::inside(const Chart& part, const CutMask& cut) const {
  CutMask own(part.mesh.n_edges(), 0);
  for (const EdgeHandle e : part.mesh.edges()) {
    if (!part.mesh.is_boundary(e)) own[e.idx()] = cut[edge_of_chart(part, part.mesh.halfedge_handle(e, 0)).idx()];
  }
  return own;
}

/// The edges and their mirror image.
CutMask FirstCuts::symmetric(const std::vector<VertexPair>& edges) const {
  CutMask cut(chart_.mesh.n_edges(), 0);
  for (const VertexPair& ends : edges) cut[edge_between_.at(sorted_ends(ends)).idx()] = 1;
  return mirrored_.with_image(cut);
}

/// (k, 2) pairs of input vertices.
VertexPairs FirstCuts::barred_edges() const {
  std::vector<VertexPair> edges;
  for (const EdgeHandle e : chart_.mesh.edges()) {
    if (barred_[e.idx()] != 0) edges.push_back(ends_in_input(chart_.mesh.halfedge_handle(e, 0)));
  }
  VertexPairs pairs(static_cast<Eigen::Index>(edges.size()), 2);
  for (std::size_t i = 0; i < edges.size(); ++i) pairs.row(static_cast<Eigen::Index>(i)) << edges[i][0], edges[i][1];
  return pairs;
}

/// Darts and seams of one of its pieces.
void FirstCuts::add_lines(const CutSet& set, std::size_t piece, std::vector<Candidate>& found) const {
  CutWishes wishes;
  wishes.count = kPlaces;
  wishes.strain = aim_;
  wishes.longest = wishes_.longest - set.proposal.length;
  wishes.no_seam = barred_edges();
  PieceFigures before = set.figures[piece];
  before.strain = std::numeric_limits<double>::infinity();  // it may rise on the way, while the energy falls
  for (const CutKind kind : {CutKind::seam, CutKind::dart}) {
    try {
      PieceSearch search(set.pieces[piece], kind, Effort::quick, wishes, trials_, go_on_);
      for (const DartProposal& cut : search.search(before)) {
        const double gain = 1 - cut.energy / cut.energy_before;
        found.push_back({symmetric(cut.edges), gain, gain / cut.length});
      }
    } catch (const FlattenError& error) {
      if (error.code != ErrorCode::no_proposal) throw;
    }
  }
}

/// Cuts through one of its pieces: they help where no single line does. A part that folds when it is solved quickly has
/// no figure without a cut: then the shortest come first, and the full runs tell what they gain.
void FirstCuts::add_halves(const CutSet& set, std::size_t piece, std::vector<Candidate>& found) const {
  const Chart& part = set.pieces[piece];
  const auto new_token = [&] { return StopToken([&](const char*) { return go_on_(); }); };
  const CutTrials trials(part, trials_.options(), new_token());
  const std::vector<CutMask> halves = halves_of(part);
  std::vector<Candidate> tried(halves.size());
  run_in_threads(
      halves.size(), num_cores(),
      [&](std::size_t i) {
        const OnOneCore on_one_core;
        const CutMask own = inside(part, halves[i]);
        const double gain = 1 - trials.energy_when_cut(own, new_token()) / trials.energy_uncut();
        tried[i] = {halves[i], gain, gain / length_of_cut(part.mesh, own)};
      },
      [&] { go_on_(); });
  std::copy_if(tried.begin(), tried.end(), std::back_inserter(found),
               [](const Candidate& candidate) { return candidate.gain >= kWorthSewing; });
}

/// Of a part; where the chart has a mirror image, each half in the two ways that are symmetric.
std::vector<CutMask> FirstCuts::halves_of(const Chart& part) const {
  const Chart ordered = in_canonical_order(part, go_on_);
  const auto in_chart = [&](EdgeHandle e) {
    const HalfedgeHandle h = ordered.mesh.halfedge_handle(e, 0);
    const auto [from, to] = source_edge(ordered, h);
    return edge_of_chart(part, part.mesh.find_halfedge(VertexHandle(from), VertexHandle(to)));
  };
  CutMask barred(ordered.mesh.n_edges(), 0);
  for (const EdgeHandle e : ordered.mesh.edges()) {
    if (!ordered.mesh.is_boundary(e)) barred[e.idx()] = barred_[in_chart(e).idx()];
  }
  std::vector<CutMask> cuts;
  for (const CutMask& half : halving_cuts(ordered.mesh, barred)) {
    CutMask drawn(chart_.mesh.n_edges(), 0);
    for (const EdgeHandle e : ordered.mesh.edges()) {
      if (half[e.idx()] != 0) drawn[in_chart(e).idx()] = 1;
    }
    for (const CutMask& cut : mirrored_.both_ways(drawn)) {
      CutMask symmetric = mirrored_.with_image(cut);
      const bool is_known = std::find(cuts.begin(), cuts.end(), symmetric) != cuts.end();
      if (!is_known && length_of_cut(part.mesh, inside(part, symmetric)) > 0) cuts.push_back(std::move(symmetric));
    }
  }
  return cuts;
}

/// Of all that is made of a part, scene units squared.
double FirstCuts::energy_within(const CutSet& set, const Chart& part) {
  double energy = 0;
  for (std::size_t i = 0; i < set.pieces.size(); ++i) {
    if (has_face_of(part, set.pieces[i])) energy += set.figures[i].energy * set.figures[i].area;
  }
  return energy;
}

std::optional<FirstCuts::CutSet> FirstCuts::cut_once_more(const CutSet& set) const {
  const auto has_less = [](const PieceFigures& a, const PieceFigures& b) { return a.strain < b.strain; };
  const auto worst = static_cast<std::size_t>(std::max_element(set.figures.begin(), set.figures.end(), has_less) -
                                              set.figures.begin());
  const Chart& part = set.pieces[worst];
  trials_.take(set.proposal.edges);
  std::vector<Candidate> candidates;
  add_lines(set, worst, candidates);
  add_halves(set, worst, candidates);
  const auto is_better = [](const Candidate& a, const Candidate& b) {
    const bool a_is_large = a.gain >= kLargeGain, b_is_large = b.gain >= kLargeGain;
    return a_is_large != b_is_large ? a_is_large : a.gain_for_length > b.gain_for_length;
  };
  std::stable_sort(candidates.begin(), candidates.end(), is_better);
  std::vector<CutMask> tried;
  for (const Candidate& candidate : candidates) {
    if (tried.size() == kMostTrials) break;
    CutMask cut = set.cut;
    for (std::size_t e = 0; e < cut.size(); ++e) cut[e] = cut[e] != 0 || candidate.cut[e] != 0;
    const bool is_known = std::find(tried.begin(), tried.end(), cut) != tried.end();
    if (is_known || length_of_cut(chart_.mesh, cut) > wishes_.longest) continue;
    tried.push_back(cut);
    CutSet more = flatten(cut);
    // The strain may rise on the way, where halves have more outline to hold than the whole.
    const double before = energy_within(set, part), after = energy_within(more, part);
    if (more.lies_flat && after <= (1 - kWorthSewing) * before) return more;
  }
  return std::nullopt;
}

/// But for those that are hardly better than one with fewer cuts. What meets the aim is better. That with most cuts
/// first; of too many, those whose strains are about evenly apart, as ratios.
std::vector<DartProposal> FirstCuts::best_of(const std::vector<CutSet>& sets) const {
  std::vector<DartProposal> best;
  for (const CutSet& set : sets) {
    const double strain = set.proposal.strain;
    const bool meets_aim = !best.empty() && strain <= aim_ && best.back().strain > aim_;
    if (best.empty() || meets_aim || strain <= (1 - kWorthSewing) * best.back().strain) best.push_back(set.proposal);
  }
  std::reverse(best.begin(), best.end());
  const auto count = static_cast<std::size_t>(wishes_.count);
  if (best.size() <= count) return best;
  std::vector<DartProposal> chosen{best.front()};
  const double least = std::max(best.front().strain, kFlat), ratio = best.back().strain / least;
  for (std::size_t i = 1; i < best.size() && chosen.size() < count; ++i) {
    const double step = static_cast<double>(chosen.size()) / static_cast<double>(count - 1);
    const bool is_far_enough = best[i].strain >= least * std::pow(ratio, step) * (1 - kWorthSewing);
    const bool are_all_needed = best.size() - i <= count - chosen.size();
    if (is_far_enough || are_all_needed) chosen.push_back(best[i]);
  }
  return chosen;
}

std::vector<DartProposal> FirstCuts::search() {
  const CutMask opened = opening();
  if (length_of_cut(chart_.mesh, opened) == 0) throw none_serves(input_chart_, wishes_);
  std::vector<CutSet> sets{flatten(opened)};
  const DartProposal& least = sets.front().proposal;
  if (!sets.front().lies_flat) throw none_serves(input_chart_, wishes_);
  if (least.length > wishes_.longest) throw too_long(input_chart_, least.length, wishes_.longest);
  while (sets.size() <= kMostCuts && sets.back().proposal.strain > aim_) {
    std::optional<CutSet> more = cut_once_more(sets.back());
    if (!more) break;
    sets.push_back(std::move(*more));
  }
  return best_of(sets);
}

}  // namespace wirewarp
