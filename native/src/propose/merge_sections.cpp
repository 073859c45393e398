// SPDX-License-Identifier: GPL-3.0-or-later
#include "propose/merge_sections.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "feasibility/ranks.h"
#include "in_threads.h"
#include "mesh/geometry.h"
#include "propose/cut_chains.h"

namespace wirewarp {
namespace {

/// Lengths of sections that differ by less, as a share of the longest, are equal: the same order however the input is
/// turned.
constexpr double kSameLength = 1e-9;

/// With 20, no section goes from the finest set of a penguin, where with 40 a third of its length does.
constexpr int kMergeFactorizations = 40;

InternalOptions without_long_runs(InternalOptions options) {
  options.max_factorizations = std::min(options.max_factorizations, kMergeFactorizations);
  options.mends_folds = false;
  return options;
}

/// Both halves of a section; none of a single edge.
std::vector<HalfEdgeChain> halves_of(const HalfEdgeMesh& mesh, const HalfEdgeChain& section) {
  const double half = length_of(mesh, section) / 2;
  double passed = 0;
  const auto middle = std::find_if(section.begin(), section.end(), [&](HalfedgeHandle h) {
    passed += edge_length(mesh, h);
    return passed > half;
  });
  if (middle == section.begin() || middle == section.end()) return {};
  return {HalfEdgeChain(section.begin(), middle), HalfEdgeChain(middle, section.end())};
}

/// The longest first.
std::vector<HalfEdgeChain> sorted_by_length(const HalfEdgeMesh& mesh, std::vector<HalfEdgeChain> sections) {
  std::vector<double> lengths;
  for (const HalfEdgeChain& section : sections) lengths.push_back(length_of(mesh, section));
  const double longest = lengths.empty() ? 0 : *std::max_element(lengths.begin(), lengths.end());
  const std::vector<int> ranks = ranks_of(lengths, kSameLength * longest);
  std::vector<std::size_t> order(sections.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return ranks[a] > ranks[b]; });
  std::vector<HalfEdgeChain> sorted;
  for (const std::size_t i : order) sorted.push_back(std::move(sections[i]));
  return sorted;
}

class Merging {
 public:
  Merging(CutState state, const Chart& chart, const MirroredCuts& mirrored, double most_strain,
          const ExactEvaluation& exact)
      : state_(std::move(state)), chart_(chart), mirrored_(mirrored), most_strain_(most_strain), exact_(exact) {}

  CutState run() {
    while (open_one(false) || open_one(true)) continue;
    return std::move(state_);
  }

 private:
  /// Whether one more section, or half of one, could go. Several are evaluated at a time; the first that may go is
  /// taken.
  bool open_one(bool is_half) {
    const std::vector<CutMask> candidates = list_candidates(is_half);
    const std::size_t at_once = num_cores();
    for (std::size_t first = 0; first < candidates.size(); first += at_once) {
      std::vector<std::optional<CutState>> tried(std::min(at_once, candidates.size() - first));
      run_in_threads(
          tried.size(), num_cores(),
          [&](std::size_t i) {
            const OnOneCore on_one_core;
            tried[i] = without(candidates[first + i]);
          },
          [&] { exact_.stop().may_go_on(); });
      for (std::size_t i = 0; i < tried.size(); ++i) {
        if (tried[i]) {
          state_ = std::move(*tried[i]);
          return true;
        }
        rejected_[candidates[first + i]] = beside(candidates[first + i]);
      }
    }
    return false;
  }

  /// Each its own mirror image. Those that were rejected beside the same pieces are left out.
  std::vector<CutMask> list_candidates(bool are_halves) const {
    std::vector<HalfEdgeChain> sections;
    for (HalfEdgeChain& whole : sections_of(chart_.mesh, state_.cut)) {
      if (are_halves) {
        for (HalfEdgeChain& half : halves_of(chart_.mesh, whole)) sections.push_back(std::move(half));
      } else {
        sections.push_back(std::move(whole));
      }
    }
    std::vector<CutMask> candidates;
    for (const HalfEdgeChain& section : sorted_by_length(chart_.mesh, std::move(sections))) {
      CutMask mask = mirrored_.with_image(cut_along(chart_.mesh, section));
      for (std::size_t e = 0; e < mask.size(); ++e) mask[e] = mask[e] != 0 && state_.cut[e] != 0;
      const auto known = rejected_.find(mask);
      if (known != rejected_.end() && known->second == beside(mask)) continue;
      if (std::find(candidates.begin(), candidates.end(), mask) == candidates.end())
        candidates.push_back(std::move(mask));
    }
    return candidates;
  }

  std::vector<VertexPair> edges_of(const CutMask& mask) const {
    std::vector<VertexPair> edges;
    for (const EdgeHandle e : chart_.mesh.edges()) {
      if (mask[e.idx()] != 0) edges.push_back(source_edge(chart_, chart_.mesh.halfedge_handle(e, 0)));
    }
    return edges;
  }

  FlatPieces beside(const CutMask& mask) const { return pieces_beside(state_.pieces, edges_of(mask)); }

  /// None unless all pieces that are new then lie flat, with little strain.
  std::optional<CutState> without(const CutMask& mask) const {
    CutState after{state_.cut, exact_.with_cut(state_.pieces, {}, edges_of(mask))};
    for (std::size_t e = 0; e < mask.size(); ++e) after.cut[e] = after.cut[e] != 0 && mask[e] == 0;
    for (const std::shared_ptr<const FlatPiece>& piece : after.pieces) {
      if (std::find(state_.pieces.begin(), state_.pieces.end(), piece) != state_.pieces.end()) continue;
      if (piece->error || piece->strain > most_strain_) return std::nullopt;
    }
    return after;
  }

  CutState state_;
  const Chart& chart_;
  const MirroredCuts& mirrored_;
  const double most_strain_;
  const ExactEvaluation& exact_;
  std::map<CutMask, FlatPieces> rejected_;  // with the pieces beside them
};

}  // namespace

CutState merge_sections(CutState state, const Chart& chart, const MirroredCuts& mirrored, double most_strain,
                        const ExactEvaluation& exact) {
  const ExactEvaluation quick(exact.surface(), without_long_runs(exact.options()), exact.stop());
  return Merging(std::move(state), chart, mirrored, most_strain, quick).run();
}

}  // namespace wirewarp
