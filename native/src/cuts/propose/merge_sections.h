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

/// A cut of a chart and all pieces of the input with it.
struct CutState {
  CutMask cut;
  FlatPieces pieces;
};

/// Without the lines that merging removes, the final mesh is coarser, so some pieces may need more strain than they
/// needed while they were merged, mostly on a mesh of a few hundred triangles. Then others are merged, at most this
/// many times: enough for a cow, which needs five.
inline constexpr int kMostMerges = 6;

/// The pieces that a merger may make.
struct MergeRules {
  double narrowest = 0;       // least width of a new piece, scene units, unless an old piece is as narrow
  double least_solidity = 0;  // least solidity of a new piece, unless an old piece has as little
};

/// Removes sections of seams from a cut, the longest first, until no more can be removed. If no whole section can be
/// removed, it tries halves, and the parts before and after the sharpest corner. A section and its mirror image are
/// removed together, after an exact evaluation of the pieces beside them. The new pieces must have a flat shape with at
/// most the allowed strain or the strain of one of the old pieces. Other pieces that had no flat shape before are
/// ignored.
class SectionMerger {
 public:
  /// chart, mirrored and exact are kept by reference. state: a cut of the chart, and the pieces with it.
  SectionMerger(CutState state, const Chart& chart, const MirroredCuts& mirrored, const ExactEvaluation& exact,
                const MergeRules& rules = {});

  /// Continues from the state. report: called with the share of candidates that were tried. Throws Stopped; then the
  /// state is the last accepted one.
  void run(double most_strain, const std::function<void(double)>& report);

  /// Returns to the first state. From then on, sections beside pieces that are narrower than `first` come first.
  /// Unwanted pieces stay unwanted.
  void restart(double first);

  /// Returns to the last state without these pieces of the state, and makes none of them again, nor pieces that contain
  /// all of one uncut. Ignores pieces of the first state. Returns whether the state has changed.
  bool undo(const FlatPieces& unwanted);

  /// The state, evaluated exactly.
  const CutState& state() const { return state_; }

 private:
  /// All pieces with a section opened.
  struct Trial {
    double strain;  // of the new pieces
    FlatPieces pieces;
    bool is_final;  // whether FlatPiece::is_final is true for all new pieces
  };

  /// What a trial changes: opening a section replaces these pieces, whatever the other pieces of the state are.
  struct Replacement {
    FlatPieces before;  // all that change; those beside the section if they were not flattened
    FlatPieces after;   // the new pieces; empty if they were not allowed, because most are not, and take much memory
    double strain;      // of the new pieces; a lower bound if they were not flattened
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
  double first_;                   // sections beside pieces that are narrower than this come first
  std::vector<CutState> earlier_;  // all states before
  FlatPieces unwanted_;            // see undo()
  double most_strain_ = 0;
  std::function<void(double)> report_;
  std::map<CutMask, std::vector<Replacement>> known_;             // all trials of each section
  std::map<std::shared_ptr<const FlatPiece>, bool> comes_first_;  // pieces that were measured
};

}  // namespace wirewarp
