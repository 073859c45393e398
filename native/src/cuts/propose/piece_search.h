// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "cuts/propose/cut_candidates.h"
#include "cuts/propose/flat_pieces.h"
#include "cuts/propose/mirror_image.h"
#include "wirewarp/propose.h"

namespace wirewarp {

/// How many cuts a search evaluates exactly.
enum class Effort {
  thorough,  // also cuts that the coarse copy may rank too low, and mirror images
  quick,     // only the best cuts, because each cut is one of many in a set
};

FlattenError no_proposal(const Chart& chart, ErrorArguments arguments);

/// Runs a search, and returns its error no_proposal; nullopt if the search has no error. Throws other errors.
template <typename Search>
std::optional<FlattenError> refusal_of(const Search& search) {
  try {
    search();
  } catch (const FlattenError& error) {
    if (error.code != ErrorCode::no_proposal) throw;
    return error;
  }
  return std::nullopt;
}

/// Returns the error no_proposal for a piece that no cut helps. strain: strain of the piece without cuts.
FlattenError none_helps(const Chart& chart, CutKind kind, double strain);

/// Adds a cut to the proposals, and its mirror image if there is one. both: figures with both cuts; nullopt if one cut
/// alone is better.
void add_with_image(DartProposal cut, std::optional<DartProposal> image, const std::optional<PieceFigures>& both,
                    std::vector<DartProposal>& proposals);

/// Searches one piece: ranks candidates on a coarse copy, and evaluates the best candidates exactly.
class PieceSearch {
 public:
  /// piece: index of the piece to search. The arguments must outlive the object.
  PieceSearch(const FlatPieces& pieces, std::size_t piece, CutKind kind, Effort effort, const CutOptions& cut_options,
              const ExactEvaluation& exact);

  /// Returns the cuts, the best first; DartProposal::piece is not set. Throws no_proposal.
  std::vector<DartProposal> search() const;

  /// Returns the helpful cuts along these chains, the best first; empty if no cut helps. DartProposal::piece is not
  /// set.
  std::vector<DartProposal> best_of(const std::vector<HalfEdgeChain>& chains) const;

  /// Throws no_proposal if the piece is flat enough.
  void check_strain() const;

  /// Returns the best cuts of the coarse copy as chains of the chart, one of each mirrored pair. Throws no_proposal if
  /// there is no room for a cut.
  std::vector<HalfEdgeChain> candidates() const { return without_mirror_images(best_chains()); }

  /// Returns the mirror image of a chain; empty if there is none. Also returns an empty chain if the image has the same
  /// edges as the chain, cuts a wire, or follows a forbidden edge.
  HalfEdgeChain image_of(const HalfEdgeChain& chain) const;

  /// Returns the mirror image of a path; empty if there is none. The path must be along or beside a chain for which
  /// image_of() is not empty.
  MeshPath image_of(const MeshPath& path) const { return mirrored(chart_, image_, path); }

  bool is_beside(const HalfEdgeChain& a, const HalfEdgeChain& b) const {
    return are_beside(chart_.mesh, size_, ends_of(a), ends_of(b));
  }

  /// Returns a proposal with these figures, without edges and length.
  DartProposal proposal_with(const PieceFigures& after) const;

  bool is_worth_sewing(const PieceFigures& after) const;

  const Chart& chart() const { return chart_; }
  const Forbidden& forbidden() const { return forbidden_; }
  const PieceFigures& before() const { return before_; }

 private:
  struct Helpful {
    HalfEdgeChain chain;
    HalfEdgeChain image;  // mirror image of the chain; empty if there is none
    PieceFigures alone;
    std::optional<PieceFigures> with_image;  // set if the chain and its image together are better than `alone`

    double strain() const { return with_image ? with_image->strain : alone.strain; }
  };

  std::vector<HalfEdgeChain> best_chains() const;
  std::vector<HalfEdgeChain> without_mirror_images(const std::vector<HalfEdgeChain>& chains) const;
  std::vector<std::optional<PieceFigures>> evaluate(const std::vector<HalfEdgeChain>& chains) const;
  std::vector<Helpful> find_helpful(const std::vector<HalfEdgeChain>& chains) const;
  std::vector<Helpful> best_apart(std::vector<Helpful> helpful) const;
  DartProposal proposal_of(const HalfEdgeChain& chain, const PieceFigures& after) const;
  std::vector<VertexPair> edges_of(const HalfEdgeChain& chain) const;
  CutEnds ends_of(const HalfEdgeChain& chain) const {
    return {chart_.mesh.from_vertex_handle(chain.front()), chart_.mesh.to_vertex_handle(chain.back())};
  }

  const FlatPieces& pieces_;
  const Chart& input_chart_;
  const Chart chart_;  // in canonical order
  const double size_;  // √area of the chart
  const std::vector<VertexHandle> image_;
  const Forbidden forbidden_;
  const CutKind kind_;
  const Effort effort_;
  const CutOptions& cut_options_;
  const ExactEvaluation& exact_;
  const PieceFigures before_;
};

}  // namespace wirewarp
