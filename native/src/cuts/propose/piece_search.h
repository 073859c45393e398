// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "cuts/propose/cut_candidates.h"
#include "cuts/propose/flat_pieces.h"
#include "cuts/propose/mirror_image.h"
#include "wirewarp/propose.h"

namespace wirewarp {

/// How much is evaluated exactly.
enum class Effort {
  thorough,  // what the coarse copy may have mistaken, too, and mirror images
  quick,     // the best alone: of several cuts on the way to a set
};

/// That no cut of a piece with this strain helps.
FlattenError none_helps(const Chart& chart, CutKind kind, double strain);

/// The search in one piece: candidates are ranked on a coarse copy, and the best of them evaluated exactly.
class PieceSearch {
 public:
  /// piece: one of the pieces. All references are kept.
  PieceSearch(const FlatPieces& pieces, std::size_t piece, CutKind kind, Effort effort, const CutOptions& cut_options,
              const ExactEvaluation& exact);

  /// The best first; without piece. Throws no_proposal.
  std::vector<DartProposal> search() const;

  /// The best of some chains first; without piece. Empty if none helps.
  std::vector<DartProposal> best_of(const std::vector<HalfEdgeChain>& chains) const;

  /// Throws no_proposal if the piece is flat enough.
  void check_strain() const;

  /// The best cuts of the coarse copy, on the chart; of mirror images one. Throws no_proposal if there is no room.
  std::vector<HalfEdgeChain> candidates() const { return without_mirror_images(best_chains()); }

  /// The mirror image; empty if there is none but the chain itself, or if it would cut a wire or a forbidden line.
  HalfEdgeChain image_of(const HalfEdgeChain& chain) const;

  /// The mirror image of a path along or beside a chain that has one; empty if the edges it crosses have none.
  MeshPath image_of(const MeshPath& path) const { return mirrored(chart_, image_, path); }

  /// Whether both ends are near those of the other.
  bool is_beside(const HalfEdgeChain& a, const HalfEdgeChain& b) const {
    return are_beside(chart_.mesh, size_, ends_of(a), ends_of(b));
  }

  /// Whether figures of a cut gain enough.
  bool is_worth_sewing(const PieceFigures& after) const;

  /// In canonical order.
  const Chart& chart() const { return chart_; }
  const Chart& input_chart() const { return input_chart_; }
  const Forbidden& forbidden() const { return forbidden_; }
  const PieceFigures& before() const { return before_; }

 private:
  struct Helpful {
    HalfEdgeChain chain;
    HalfEdgeChain image;  // its mirror image; empty: none
    PieceFigures alone;
    std::optional<PieceFigures> with_image;  // none unless that is better

    double strain() const { return with_image ? with_image->strain : alone.strain; }
  };

  std::vector<HalfEdgeChain> best_chains() const;
  std::vector<HalfEdgeChain> without_mirror_images(const std::vector<HalfEdgeChain>& chains) const;
  std::vector<std::optional<PieceFigures>> evaluate(const std::vector<HalfEdgeChain>& chains) const;
  std::vector<Helpful> find_helpful(const std::vector<HalfEdgeChain>& chains) const;
  DartProposal proposal_of(const HalfEdgeChain& chain, const PieceFigures& after) const;
  std::vector<VertexPair> edges_of(const HalfEdgeChain& chain) const;
  CutEnds ends_of(const HalfEdgeChain& chain) const {
    return {chart_.mesh.from_vertex_handle(chain.front()), chart_.mesh.to_vertex_handle(chain.back())};
  }

  const FlatPieces& pieces_;
  const Chart& input_chart_;
  const Chart chart_;  // in canonical order
  const double size_;  // root of its area
  const std::vector<VertexHandle> image_;
  const Forbidden forbidden_;
  const CutKind kind_;
  const Effort effort_;
  const CutOptions& cut_options_;
  const ExactEvaluation& exact_;
  const PieceFigures before_;
};

}  // namespace wirewarp
