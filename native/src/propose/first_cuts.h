// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "charts/chart.h"
#include "feasibility/cut_mask.h"
#include "feasibility/mirrored_cuts.h"
#include "propose/full_trial.h"
#include "wirewarp/propose.h"

namespace wirewarp {

/// Seams are what a piece lacks that does not lie flat: it is closed, has handles, or its outline cannot hold it.
/// Neither the mesh nor its wires are at fault.
bool lacks_seams(const Chart& chart, const FlattenError& error);

/// The search for sets of seams in one piece that has no flat shape: first those that let all of it lie flat, then one
/// cut after the other through what is strained most: of those that take much of its distortion, lines and halves
/// alike, the one that takes most for its length.
class FirstCuts {
 public:
  /// All are kept by reference. flattened: the input, in the middle of its material.
  FirstCuts(const FlattenInput& flattened, const Chart& chart, const CutWishes& wishes, FullTrials& trials,
            const std::function<bool()>& go_on);

  /// The set with most cuts first; without piece. Throws no_proposal.
  std::vector<DartProposal> search();

 private:
  /// A set of cuts, flattened in full.
  struct CutSet {
    CutMask cut;
    std::vector<Chart> pieces;
    std::vector<PieceFigures> figures;  // of the pieces
    DartProposal proposal;
    bool lies_flat = false;
  };

  /// A further cut.
  struct Candidate {
    CutMask cut;      // symmetric
    double gain = 0;  // share of the energy of the piece that it takes
    double gain_for_length = 0;
  };

  CutMask opening() const;
  CutSet flatten(const CutMask& cut) const;
  static double energy_within(const CutSet& set, const Chart& part);
  std::optional<CutSet> cut_once_more(const CutSet& set) const;
  std::vector<DartProposal> best_of(const std::vector<CutSet>& sets) const;
  void add_lines(const CutSet& set, std::size_t piece, std::vector<Candidate>& found) const;
  void add_halves(const CutSet& set, std::size_t piece, std::vector<Candidate>& found) const;
  std::vector<CutMask> halves_of(const Chart& part) const;
  EdgeHandle edge_of_chart(const Chart& part, HalfedgeHandle h) const;
  CutMask inside(const Chart& part, const CutMask& cut) const;
  CutMask symmetric(const std::vector<VertexPair>& edges) const;
  VertexPairs barred_edges() const;
  std::vector<VertexPair> edges_of(const CutMask& cut) const;
  VertexPair ends_in_input(HalfedgeHandle h) const;

  const FlattenInput& flattened_;
  const Chart& input_chart_;
  const Chart chart_;                              // in canonical order; its sources are the other one's
  std::map<VertexPair, EdgeHandle> edge_between_;  // the ends in the input, the smaller one first
  const std::vector<VertexHandle> image_;
  const MirroredCuts mirrored_;
  CutMask barred_;
  const CutWishes& wishes_;
  const double aim_;
  FullTrials& trials_;
  const std::function<bool()>& go_on_;
};

}  // namespace wirewarp
