// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <vector>

#include "cuts/feasibility/cut_mask.h"
#include "cuts/feasibility/mirrored_cuts.h"
#include "cuts/propose/flat_pieces.h"
#include "surface/charts/chart.h"

namespace wirewarp {

struct CutState {
  CutMask cut;
  FlatPieces pieces;
};

/// Largest number of attempts to merge the pieces of a set. The final mesh lacks the lines that merging removes, so it
/// is coarser. Therefore, some merged pieces may need more strain in the end, mostly on a mesh of a few hundred
/// triangles. The next attempt avoids these pieces. A cow needs five attempts.
inline constexpr int kMostMerges = 6;

struct MergeRules {
  double narrowest = 0;       // least width of a new piece, scene units, unless an old piece is as narrow
  double least_solidity = 0;  // least solidity of a new piece, unless an old piece has as little
};

/// Removes sections of seams from a cut, the longest first, until no more sections can be removed. If no whole section
/// can be removed, the merger tries half sections, and the parts before and after the sharpest corner. A section and
/// its mirror image are removed together, after an exact evaluation of the pieces beside them. The new pieces must have
/// a flat shape, and at most the allowed strain or the strain of one of the old pieces. Errors of other pieces are
/// ignored if these pieces had no flat shape before.
class SectionMerger {
 public:
  /// Keeps references to chart, mirrored and exact. state: a cut of the chart, and the pieces with it.
  SectionMerger(CutState state, const Chart& chart, const MirroredCuts& mirrored, const ExactEvaluation& exact,
                const MergeRules& rules = {});

  /// Removes sections from the current state. most_strain: the allowed strain. report: called with the share of
  /// candidates that were tried. Throws Stopped. Then the state is the last accepted state.
  void run(double most_strain, const std::function<void(double)>& report);

  /// Returns to the first state. From then on, sections beside pieces that are narrower than `first` come first.
  /// Unwanted pieces stay unwanted.
  void restart(double first);

  /// Returns to the last state without the unwanted pieces. Later runs do not make these pieces again, or pieces that
  /// contain all of an unwanted piece without a cut inside it. Ignores unwanted pieces that a piece of the first state
  /// contains in this way. Returns whether the state has changed.
  bool undo(const FlatPieces& unwanted);

  const CutState& state() const { return state_; }

 private:
  struct Trial {
    double strain;  // largest strain of the new pieces
    FlatPieces pieces;
    bool is_final;  // whether FlatPiece::is_final is true for all new pieces
  };

  /// Opening a section replaces the pieces `before` by the pieces `after`, whatever the other pieces of the state are.
  struct Replacement {
    FlatPieces before;  // all pieces that change; if `after` was not flattened, only the pieces beside the section
    FlatPieces after;   // the new pieces; empty if they were not allowed, to save memory
    double strain;      // largest strain of the new pieces; a lower bound if they were not flattened
  };

  bool open_one(bool is_half);
  std::vector<CutMask> list_candidates(bool are_halves);
  FlatPieces beside(const CutMask& mask) const { return pieces_beside(state_.pieces, edges_of(chart_, mask)); }
  double allowed_beside(const FlatPieces& pieces) const;
  bool had_error(const Chart& chart) const;
  bool is_unwanted(const Chart& chart) const;
  bool comes_first(const std::shared_ptr<const FlatPiece>& piece);
  bool is_too_narrow(const FlatPiece& piece, const FlatPieces& old) const;
  bool has_long_arms(const FlatPiece& piece, const FlatPieces& old) const;
  double least_strain_without(const CutMask& mask, const FlatPieces& joined, double allowed) const;
  Trial without(const CutMask& mask, const FlatPieces& joined, double allowed, const ExactEvaluation& exact) const;
  Replacement try_without(const CutMask& mask) const;
  const Replacement* known(const CutMask& mask) const;
  CutState replaced(const CutMask& mask, const Replacement& replacement) const;

  CutState state_;
  const Chart& chart_;
  const MirroredCuts& mirrored_;
  const bool has_other_measure_;  // strain is measured in threads or beyond eases, so free maps cannot estimate it
  const ExactEvaluation& exact_;
  const ExactEvaluation quick_;  // limited to fewer factorizations
  const MergeRules rules_;
  double first_;                   // least width: sections beside narrower pieces come first
  std::vector<CutState> earlier_;  // all earlier states, the first state first
  FlatPieces unwanted_;            // see undo()
  double most_strain_ = 0;
  std::function<void(double)> report_;
  std::map<CutMask, std::vector<Replacement>> known_;             // all trials of each section
  std::map<std::shared_ptr<const FlatPiece>, bool> comes_first_;  // known results of comes_first()
};

}  // namespace wirewarp
