// SPDX-License-Identifier: GPL-3.0-or-later
#include "cuts/propose/piece_search.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>

#include "base/in_threads.h"
#include "cuts/propose/canonical_order.h"
#include "cuts/propose/coarse_evaluation.h"
#include "cuts/propose/rank_cuts.h"
#include "newton/newton_constants.h"
#include "surface/mesh/geometry.h"

namespace wirewarp {
namespace {

/// The coarse copy may rank almost equal cuts wrongly, so more cuts are evaluated exactly than requested:
/// - kMorePlaces: at this many more places; on six panels, the best dart is the same with 0 or 6, but with 0, a later
///   dart is worse on four
/// - kShareEvaluated: up to this share of all cuts tried on the copy
constexpr int kMorePlaces = 3;
constexpr double kShareEvaluated = 0.05;

/// A cut is worth sewing if it lowers the energy and the strain by at least this share. Smaller gains cannot be felt:
/// 2% of a strain of 25% is kMayStay.
constexpr double kLeastGain = 0.02;

/// By default, pieces with at most this strain are not cut, because this strain does not show in any fabric.
constexpr double kMayStay = 0.005;

/// On the fine mesh, a path may be longer than on the coarse copy by this factor. For example, it may avoid a forbidden
/// diagonal: two sides of a square are 1.41 times as long. Longer paths are detours around wires, and are dropped.
constexpr double kDetour = 1.5;

struct Grid {
  CandidatePoints points;
  double faces;  // requested for the coarse copy
};

/// In a quick search, half of the points and faces lead to equally good sets in a quarter of the time. In a thorough
/// search, half are too few: a hat's best dart was only the eleventh in their ranking.
Grid grid_of(Effort effort) { return effort == Effort::thorough ? Grid{{24, 14}, 800} : Grid{{12, 8}, 400}; }

std::string name_of(CutKind kind) { return kind == CutKind::dart ? "dart" : "seam"; }

FlattenError no_room(const Chart& chart, CutKind kind, const CutOptions& cut_options) {
  return no_proposal(
      chart, {{"reason", "no_room"}, {"kind", name_of(kind)}, {"is_restricted", cut_options.no_seam.rows() > 0}});
}

std::vector<char> vertices_on_wires(const Chart& chart) {
  std::vector<char> is_on_wire(chart.mesh.n_vertices(), 0);
  for (const WirePart& part : chart.wire_parts) {
    if (part.kind == WireKind::boundary) continue;
    for (const HalfedgeHandle h : part.half_edges) {
      for (const VertexHandle v : {chart.mesh.from_vertex_handle(h), chart.mesh.to_vertex_handle(h)}) {
        if (!chart.mesh.is_boundary(v)) is_on_wire[v.idx()] = 1;
      }
    }
  }
  return is_on_wire;
}

/// Forbids edges that must not become seams, vertices on wires, and vertices at which all edges are forbidden.
Forbidden find_forbidden(const Chart& chart, const VertexPairs& no_seam) {
  Forbidden forbidden{vertices_on_wires(chart), PartMap(chart).mask_of(as_list(no_seam))};
  std::vector<char> has_way(chart.mesh.n_vertices(), 0);
  for (const EdgeHandle edge : chart.mesh.edges()) {
    const HalfedgeHandle h = chart.mesh.halfedge_handle(edge, 0);
    if (forbidden.edges[edge.idx()] != 0 || chart.mesh.is_boundary(edge)) continue;
    has_way[chart.mesh.from_vertex_handle(h).idx()] = has_way[chart.mesh.to_vertex_handle(h).idx()] = 1;
  }
  for (std::size_t v = 0; v < has_way.size(); ++v) {
    if (has_way[v] == 0) forbidden.vertices[v] = 1;
  }
  return forbidden;
}

/// Returns the forbidden vertices and edges of the coarse copy. A coarse edge is forbidden only if it is a forbidden
/// edge of the chart, too.
Forbidden on_copy(const CoarseCopy& copy, const HalfEdgeMesh& mesh, const Forbidden& forbidden) {
  const HalfEdgeMesh& coarse = copy.chart.mesh;
  Forbidden result{std::vector<char>(coarse.n_vertices(), 0), std::vector<char>(coarse.n_edges(), 0)};
  const auto fine = [&](VertexHandle v) { return copy.fine_vertex[v.idx()]; };
  for (const VertexHandle v : coarse.vertices()) result.vertices[v.idx()] = forbidden.vertices[fine(v).idx()];
  for (const EdgeHandle edge : coarse.edges()) {
    const HalfedgeHandle h = coarse.halfedge_handle(edge, 0);
    const HalfedgeHandle same =
        mesh.find_halfedge(fine(coarse.from_vertex_handle(h)), fine(coarse.to_vertex_handle(h)));
    if (same.is_valid()) result.edges[edge.idx()] = forbidden.edges[mesh.edge_handle(same).idx()];
  }
  return result;
}

bool have_same_edges(const HalfEdgeMesh& mesh, const HalfEdgeChain& a, const HalfEdgeChain& b) {
  std::set<EdgeHandle> of_a, of_b;
  for (const HalfedgeHandle h : a) of_a.insert(mesh.edge_handle(h));
  for (const HalfedgeHandle h : b) of_b.insert(mesh.edge_handle(h));
  return of_a == of_b;
}

/// Returns the smooth chain along a cut. If there is none, starts at the nearest vertex of the outline from which a
/// chain leads to the cut's end.
HalfEdgeChain nearest_chain(const HalfEdgeMesh& mesh, const SmoothPathFinder& paths, CutEnds cut) {
  HalfEdgeChain chain = chain_of(paths, cut);
  if (!chain.empty()) return chain;
  const SmoothPaths from_end = paths.paths_from(cut.end);
  const auto distance = [&](VertexHandle v) { return (mesh.point(v) - mesh.point(cut.start)).norm(); };
  VertexHandle nearest;
  for (const VertexHandle v : mesh.vertices()) {
    if (!mesh.is_boundary(v) || v == cut.end || !from_end.arrival[v.idx()].is_valid()) continue;
    if (!nearest.is_valid() || distance(v) < distance(nearest)) nearest = v;
  }
  return nearest.is_valid() ? chain_of(paths, {nearest, cut.end}) : HalfEdgeChain{};
}

/// Returns whether two darts have a common vertex. Such darts would form a seam, and a seam cuts the piece differently
/// than each dart alone.
bool have_common_vertex(const HalfEdgeMesh& mesh, const HalfEdgeChain& a, const HalfEdgeChain& b) {
  const std::vector<VertexHandle> of_a = vertices_along(mesh, a), of_b = vertices_along(mesh, b);
  return std::find_first_of(of_a.begin(), of_a.end(), of_b.begin(), of_b.end()) != of_a.end();
}

}  // namespace

FlattenError no_proposal(const Chart& chart, ErrorArguments arguments) {
  return FlattenError(ErrorCode::no_proposal, std::move(arguments), {{}, {}, chart.source_face});
}

FlattenError none_helps(const Chart& chart, CutKind kind, double strain) {
  std::set<int> wires;
  for (const WirePart& part : chart.wire_parts) {
    if (is_held(part)) wires.insert(part.wire_index);
  }
  return no_proposal(chart, {{"reason", "no_gain"},
                             {"kind", name_of(kind)},
                             {"strain", strain},
                             {"wires", std::vector<int>(wires.begin(), wires.end())}});
}

PieceSearch::PieceSearch(const FlatPieces& pieces, std::size_t piece, CutKind kind, Effort effort,
                         const CutOptions& cut_options, const ExactEvaluation& exact)
    : pieces_(pieces),
      input_chart_(pieces[piece]->chart),
      chart_(in_canonical_order(input_chart_, exact.stop())),
      size_(std::sqrt(surface_area(chart_.mesh))),
      image_(mirror_image(chart_, exact.stop())),
      forbidden_(find_forbidden(chart_, cut_options.no_seam)),
      kind_(kind),
      effort_(effort),
      cut_options_(cut_options),
      exact_(exact),
      before_(figures_of(pieces, input_chart_)) {}

std::vector<VertexPair> PieceSearch::edges_of(const HalfEdgeChain& chain) const {
  std::vector<VertexPair> edges;
  for (const HalfedgeHandle h : chain) edges.push_back(source_ends(chart_, h));
  return edges;
}

HalfEdgeChain PieceSearch::image_of(const HalfEdgeChain& chain) const {
  if (image_.empty()) return {};
  HalfEdgeChain image = mirrored(chart_, image_, chain);
  if (have_same_edges(chart_.mesh, chain, image)) return {};
  const bool is_forbidden = std::any_of(image.begin(), image.end(), [&](HalfedgeHandle h) {
    return forbidden_.edges[chart_.mesh.edge_handle(h).idx()] != 0 ||
           forbidden_.vertices[chart_.mesh.from_vertex_handle(h).idx()] != 0 ||
           forbidden_.vertices[chart_.mesh.to_vertex_handle(h).idx()] != 0;
  });
  return is_forbidden ? HalfEdgeChain{} : image;
}

std::vector<HalfEdgeChain> PieceSearch::best_chains() const {
  const SmoothPathFinder paths(chart_, forbidden_);
  const Grid grid = grid_of(effort_);
  const CoarseCopy copy = coarse_copy(chart_, grid.faces, exact_.stop());
  const SmoothPathFinder coarse_paths(copy.chart, on_copy(copy, chart_.mesh, forbidden_));
  const std::vector<CutEnds> candidates = list_candidates(copy.chart, coarse_paths, kind_, grid.points);
  if (candidates.empty()) throw no_room(input_chart_, kind_, cut_options_);
  std::vector<HalfEdgeChain> chains;
  bool is_way = false;
  const CutLimits limits = effort_ == Effort::thorough
                               ? CutLimits{cut_options_.count + kMorePlaces, kShareEvaluated, cut_options_.longest}
                               : CutLimits{cut_options_.count, 0, cut_options_.longest};
  const std::vector<RankedCut> ranked =
      rank_cuts(copy.chart, coarse_paths, candidates, exact_.options(), limits, exact_.stop());
  for (const RankedCut& cut : ranked) {
    HalfEdgeChain chain = nearest_chain(chart_.mesh, paths,
                                        {copy.fine_vertex[cut.ends.start.idx()], copy.fine_vertex[cut.ends.end.idx()]});
    if (chain.empty()) continue;
    is_way = true;
    const double length = length_of(chart_.mesh, chain);
    if (length > kDetour * length_of(copy.chart.mesh, chain_of(coarse_paths, cut.ends))) continue;
    const bool is_new = std::find(chains.begin(), chains.end(), chain) == chains.end();
    if (is_new && length <= cut_options_.longest) chains.push_back(std::move(chain));
  }
  if (!ranked.empty() && !is_way) throw no_room(input_chart_, kind_, cut_options_);
  return chains;
}

/// Drops each chain that is beside the mirror image of an earlier chain.
std::vector<HalfEdgeChain> PieceSearch::without_mirror_images(const std::vector<HalfEdgeChain>& chains) const {
  std::vector<HalfEdgeChain> kept, images;
  for (const HalfEdgeChain& chain : chains) {
    if (std::any_of(images.begin(), images.end(), [&](const HalfEdgeChain& image) { return is_beside(chain, image); }))
      continue;
    kept.push_back(chain);
    HalfEdgeChain image = image_of(chain);
    if (!image.empty()) images.push_back(std::move(image));
  }
  return kept;
}

/// Returns the figures of the piece after a cut along each chain; nullopt if the chain is empty, if a part has no flat
/// shape, or if the cut makes other pieces worse.
std::vector<std::optional<PieceFigures>> PieceSearch::evaluate(const std::vector<HalfEdgeChain>& chains) const {
  std::vector<std::optional<PieceFigures>> found(chains.size());
  run_on_all_cores(chains.size(), exact_.stop(), [&](std::size_t i) {
    if (chains[i].empty()) return;
    const FlatPieces after = exact_.with_cut(pieces_, edges_of(chains[i]));
    PieceFigures figures = figures_of(after, input_chart_);
    if (!figures.error && !spoils_others(pieces_, after, input_chart_)) found[i] = std::move(figures);
  });
  return found;
}

bool PieceSearch::is_worth_sewing(const PieceFigures& after) const {
  const bool has_less_energy = after.energy <= (1 - kLeastGain) * before_.energy;
  if (effort_ == Effort::quick) return has_less_energy;  // the strain may rise on the way to a good set
  return has_less_energy && after.strain <= (1 - kLeastGain) * before_.strain && after.strain < kMostStrain;
}

/// Returns the chains that help alone or with their mirror images, in their order.
std::vector<PieceSearch::Helpful> PieceSearch::find_helpful(const std::vector<HalfEdgeChain>& chains) const {
  const std::vector<std::optional<PieceFigures>> alone = evaluate(chains);
  std::vector<HalfEdgeChain> images(chains.size()), pairs(chains.size());
  for (std::size_t i = 0; i < chains.size() && effort_ == Effort::thorough; ++i) {
    if (!alone[i]) continue;
    images[i] = image_of(chains[i]);
    if (images[i].empty() || have_common_vertex(chart_.mesh, chains[i], images[i])) continue;
    pairs[i] = chains[i];
    pairs[i].insert(pairs[i].end(), images[i].begin(), images[i].end());
  }
  const std::vector<std::optional<PieceFigures>> both = evaluate(pairs);
  std::vector<Helpful> helpful;
  for (std::size_t i = 0; i < chains.size(); ++i) {
    if (!alone[i]) continue;
    Helpful cut{chains[i], images[i], *alone[i], {}};
    const bool helps_alone = is_worth_sewing(*alone[i]);
    const bool is_better = both[i] && is_worth_sewing(*both[i]) &&
                           (!helps_alone || (both[i]->energy <= (1 - kLeastGain) * alone[i]->energy &&
                                             both[i]->strain <= alone[i]->strain));
    if (is_better) cut.with_image = both[i];
    if (helps_alone || cut.with_image) helpful.push_back(std::move(cut));
  }
  return helpful;
}

/// Returns the best cuts, the best first. No cut is beside a better cut.
std::vector<PieceSearch::Helpful> PieceSearch::best_apart(std::vector<Helpful> helpful) const {
  const auto figure = [&](const Helpful& cut) { return effort_ == Effort::quick ? cut.alone.energy : cut.strain(); };
  std::stable_sort(helpful.begin(), helpful.end(),
                   [&](const Helpful& a, const Helpful& b) { return figure(a) < figure(b); });
  std::vector<Helpful> best;
  for (Helpful& cut : helpful) {
    const bool is_known = std::any_of(best.begin(), best.end(),
                                      [&](const Helpful& better) { return is_beside(better.chain, cut.chain); });
    if (!is_known && static_cast<int>(best.size()) < cut_options_.count) best.push_back(std::move(cut));
  }
  return best;
}

void add_with_image(DartProposal cut, std::optional<DartProposal> image, const std::optional<PieceFigures>& both,
                    std::vector<DartProposal>& proposals) {
  const auto place = static_cast<int>(proposals.size());
  proposals.push_back(std::move(cut));
  if (!image) return;
  proposals.push_back(std::move(*image));
  for (const int k : {place, place + 1}) {
    proposals[k].twin = 2 * place + 1 - k;
    if (!both) continue;
    proposals[k].energy_with_twin = both->energy;
    proposals[k].strain_with_twin = both->strain;
  }
}

DartProposal PieceSearch::proposal_of(const HalfEdgeChain& chain, const PieceFigures& after) const {
  DartProposal proposal = proposal_with(after);
  proposal.edges = edges_of(chain);
  proposal.length = length_of(chart_.mesh, chain);
  return proposal;
}

DartProposal PieceSearch::proposal_with(const PieceFigures& after) const {
  DartProposal proposal;
  proposal.num_pieces = after.num_pieces;
  proposal.energy = after.energy;
  proposal.energy_before = before_.energy;
  proposal.strain = after.strain;
  proposal.strain_before = before_.strain;
  return proposal;
}

void PieceSearch::check_strain() const {
  if (before_.energy <= NewtonConstants::isometric) throw no_proposal(input_chart_, {{"reason", "unfolded"}});
  const double may_stay = cut_options_.strain.value_or(kMayStay);
  if (before_.strain <= may_stay)
    throw no_proposal(input_chart_, {{"reason", "strain"}, {"strain", before_.strain}, {"limit", may_stay}});
}

std::vector<DartProposal> PieceSearch::best_of(const std::vector<HalfEdgeChain>& chains) const {
  const std::vector<Helpful> best = best_apart(find_helpful(chains));
  std::vector<HalfEdgeChain> images;
  for (const Helpful& cut : best) images.push_back(cut.image);
  const std::vector<std::optional<PieceFigures>> of_images = evaluate(images);
  std::vector<DartProposal> proposals;
  for (std::size_t i = 0; i < best.size(); ++i) {
    const Helpful& cut = best[i];
    const bool has_mirror_image = of_images[i] && (cut.with_image || is_worth_sewing(*of_images[i]));
    if (!has_mirror_image && !is_worth_sewing(cut.alone)) continue;
    std::optional<DartProposal> image;
    if (has_mirror_image) image = proposal_of(cut.image, *of_images[i]);
    add_with_image(proposal_of(cut.chain, cut.alone), std::move(image), cut.with_image, proposals);
  }
  return proposals;
}

std::vector<DartProposal> PieceSearch::search() const {
  check_strain();
  std::vector<DartProposal> proposals = best_of(candidates());
  if (proposals.empty()) throw none_helps(input_chart_, kind_, before_.strain);
  return proposals;
}

}  // namespace wirewarp
