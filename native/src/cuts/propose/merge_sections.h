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

/// Largest number of attempts to merge the pieces of a set; a cow needs five. Each attempt avoids pieces that needed
/// too much strain on the final mesh, which is coarser without the removed lines.
inline constexpr int kMostMerges = 6;

struct MergeRules {
  double narrowest = 0;             // least width of a new piece, scene units, unless an old piece is as narrow
  double least_solidity = 0;        // least solidity of a new piece, unless an old piece has as little
  int most_attempts = kMostMerges;  // number of calls of run() after which SmoothMerger only undoes merges
};

/// Removes sections of seams from a cut, with their mirror images, the longest first. New pieces must have a flat
/// shape, and at most the allowed strain or the strain of an old piece beside the section, whichever is larger.
/// Rejected trials are short, except for those of the last stage, which joins narrow pieces.
class SectionMerger {
 public:
  /// chart, mirrored and exact must outlive the object. state: a cut of the chart, and the pieces with it.
  SectionMerger(CutState state, const Chart& chart, const MirroredCuts& mirrored, const ExactEvaluation& exact,
                const MergeRules& rules = {});

  /// Removes sections from the current state. report: called with the share of tried candidates. Throws Stopped, and
  /// keeps the last accepted state.
  void run(double most_strain, const std::function<void(double)>& report);

  /// Returns to the first state. From then on, sections beside pieces narrower than the width `first` are tried first.
  /// Unwanted pieces stay unwanted.
  void restart(double first);

  /// Restores the last state without the unwanted pieces, and returns whether the state has changed. From then on, no
  /// piece contains a whole unwanted piece, unless a cut runs inside the latter. Ignores unwanted pieces that the first
  /// state contains.
  bool undo(const FlatPieces& unwanted);

  const CutState& state() const { return state_; }

 private:
  struct Trial {
    FlatPieces pieces;
    double strain = 0;     // largest strain of the new pieces; infinite if one has no flat shape or is hard to sew
    double least = 0;      // estimated least strain with more factorizations; `strain` if they would change nothing
    bool is_final = true;  // whether more factorizations would change nothing
  };

  /// Opening a section replaces the pieces `before` by the pieces `after`, whatever the other pieces of the state are.
  struct Replacement {
    FlatPieces before;  // all pieces that change; if `after` was not flattened, only the pieces beside the section
    FlatPieces after;   // the new pieces; empty if they were not allowed, to save memory
    double strain;      // largest strain of the new pieces; a lower bound if they were not flattened
    double least;       // as Trial::least
  };

  /// Which candidates are tried. A stage begins if no candidate of the earlier stages is allowed.
  enum class Stage {
    sections,
    halves,
    narrow,  // sections and halves beside narrow pieces, with all factorizations that the options allow
  };

  bool open_one(Stage stage);
  std::vector<CutMask> list_candidates(Stage stage);
  bool needs_trial(const CutMask& mask, Stage stage);
  bool is_beside_narrow(const CutMask& mask);
  FlatPieces beside(const CutMask& mask) const { return pieces_beside(state_.pieces, edges_of(chart_, mask)); }
  double allowed_beside(const FlatPieces& pieces) const;
  bool had_error(const Chart& chart) const;
  bool is_unwanted(const Chart& chart) const;
  bool comes_first(const std::shared_ptr<const FlatPiece>& piece);
  bool is_too_narrow(const FlatPiece& piece, const FlatPieces& old) const;
  bool has_long_arms(const FlatPiece& piece, const FlatPieces& old) const;
  double least_strain_of(ChangedPieces& changed, const FlatPieces& joined, double allowed) const;
  Trial flattened(ChangedPieces changed, const FlatPieces& joined, double allowed, const ExactEvaluation& exact) const;
  Replacement try_without(const CutMask& mask, bool is_patient) const;
  const Replacement* known(const CutMask& mask) const;
  CutState replaced(const CutMask& mask, const Replacement& replacement) const;

  CutState state_;
  const Chart& chart_;
  const MirroredCuts& mirrored_;
  const bool has_other_measure_;  // whether strain is along threads or beyond eases: free maps cannot estimate it
  const ExactEvaluation& exact_;
  const ExactEvaluation quick_;  // limited to fewer factorizations
  const MergeRules rules_;
  double first_;                   // scene units; sections beside pieces narrower than this come first
  std::vector<CutState> earlier_;  // all earlier states, the first state first
  FlatPieces unwanted_;            // see undo()
  double most_strain_ = 0;
  std::function<void(double)> report_;
  std::map<CutMask, std::vector<Replacement>> known_;             // all trials of each section
  std::map<std::shared_ptr<const FlatPiece>, bool> comes_first_;  // known results of comes_first()
};

}  // namespace wirewarp
