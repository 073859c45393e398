// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
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

/// The move "merge": takes sections of seams out of a cut, the longest first, until none is left that may go. If no
/// whole one may, it tries halves, and what lies before or behind the sharpest corner. A section goes with its mirror
/// image, after an exact evaluation of the pieces beside it: what they become must have a flat shape, and no more
/// strain than is allowed or than one of them had. Other pieces that had no flat shape before do not count.
class SectionMerger {
 public:
  /// chart, mirrored and exact are kept by reference. state: a cut of the chart.
  SectionMerger(CutState state, const Chart& chart, const MirroredCuts& mirrored, const ExactEvaluation& exact);

  /// Goes on from the state. report: called with the share of the candidates that were tried. Throws Stopped; then the
  /// state is the last one that was accepted.
  void run(double most_strain, const std::function<void(double)>& report);

  /// With the figures of exact, as all states on the way.
  const CutState& state() const { return state_; }

 private:
  /// What comes of opening a section.
  struct Trial {
    double strain;   // that is needed at least
    CutState after;  // valid if the strain is allowed
  };

  struct Rejected {
    FlatPieces beside;
    double strain;  // that is needed at least
  };

  bool open_one(bool is_half);
  std::vector<CutMask> list_candidates(bool are_halves) const;
  std::vector<VertexPair> edges_of(const CutMask& mask) const;
  FlatPieces beside(const CutMask& mask) const { return pieces_beside(state_.pieces, edges_of(mask)); }
  double allowed_beside(const FlatPieces& pieces) const;
  bool had_error(const Chart& chart) const;
  double least_strain_without(const CutMask& mask, double allowed) const;
  Trial without(const CutMask& mask, const ExactEvaluation& exact) const;
  Trial try_without(const CutMask& mask) const;

  CutState state_;
  const Chart& chart_;
  const MirroredCuts& mirrored_;
  const bool has_other_measure_;  // strain is that of threads, or beyond eases: free maps say nothing of it
  const ExactEvaluation& exact_;
  const ExactEvaluation quick_;  // without long runs
  double most_strain_ = 0;
  std::function<void(double)> report_;
  std::map<CutMask, Rejected> rejected_;
};

}  // namespace wirewarp
