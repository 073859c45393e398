// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "cuts/propose/flat_pieces.h"
#include "cuts/propose/smooth_sets.h"
#include "wirewarp/propose.h"

namespace wirewarp {

/// Smooths the lines of a finely cut set, then merges its pieces. The opposite order would be worse: zigzags along
/// edges work like many small darts, so merged pieces often need too much strain after their outlines are smoothed.
class SmoothMerger {
 public:
  /// least_solidity: as in MergeRules. Keeps all references.
  SmoothMerger(const PieceToCut& piece, double least_solidity, const CutOptions& cut_options,
               const ExactEvaluation& exact);

  /// Smooths the lines of a set along edges. most_strain: strain for which pieces will be merged. The smooth set may
  /// have twice this strain, or the strain of the given set if this is larger. Returns false if no line can be smooth.
  /// Throws Stopped.
  bool start(const DartProposal& set, const CutMask& cut, double most_strain);

  /// Merges pieces as SectionMerger does, up to the given share of `most_strain`. Returns false if the caller canceled.
  /// In this case, the set has the merges so far, or is unchanged if these merges need too much strain. report: called
  /// with the share of candidates that were tried.
  bool merge(double share, double most_strain, const std::function<void(double)>& report);

  /// Returns the set after smoothing the corners that merging has left. keeps_room: whether smoothing must not make
  /// more pieces too narrow. Throws Stopped.
  DartProposal smooth(double most_strain, bool keeps_room) const;

  /// Continues from a set that smooth() has returned.
  void go_on(DartProposal set) { set_ = std::move(set); }

  const DartProposal& set() const { return set_; }

 private:
  struct CutSet {
    DartProposal set;
    FlatPieces pieces;
    std::vector<int> faces;  // input face that contains each face of the cut mesh
  };

  CutSet set_along(std::vector<SurfacePath> paths) const;

  const PieceToCut& piece_;
  const double least_solidity_;
  const CutOptions& cut_options_;
  const ExactEvaluation& exact_;
  const ExactEvaluation unstopped_;  // completes the last set if the caller cancels
  DartProposal set_;
  SurfaceLines lines_;  // lines of set_
  int num_narrow_ = 0;
};

}  // namespace wirewarp
