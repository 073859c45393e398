// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "cuts/propose/flat_pieces.h"
#include "cuts/propose/merge_sections.h"
#include "cuts/propose/smooth_sets.h"
#include "wirewarp/propose.h"

namespace wirewarp {

/// Smoothing may raise the strain of the fine set to this many times the least strain for which pieces are merged. With
/// a smaller factor, many lines of the set keep their zigzags.
constexpr double kFineGrowth = 2;

/// Smooths the lines of a finely cut set, then merges its pieces. In the opposite order, pieces often get too much
/// strain, because smoothing removes zigzags that work like small darts.
class SmoothMerger {
 public:
  /// All arguments except for the rules must outlive the object. rules.narrowest must equal cut_options.narrowest.
  SmoothMerger(const PieceToCut& piece, const MergeRules& rules, const CutOptions& cut_options,
               const ExactEvaluation& exact);

  /// Smooths the lines of a set along edges. Returns false if no line can be smooth. Throws Stopped.
  /// - most_strain: strain for which pieces are merged later
  bool start(const DartProposal& set, const CutMask& cut, double most_strain);

  /// Merges pieces as SectionMerger does, up to `share` of `most_strain`. Returns false if canceled; the set then has
  /// the merges so far, unless they need too much strain. report: see SectionMerger::run().
  bool merge(double share, double most_strain, const std::function<void(double)>& report);

  /// Returns the set after smoothing the corners that merging has left. Smoothing makes no more pieces too narrow.
  /// Throws Stopped.
  DartProposal smooth(double most_strain) const;

  /// Continues from a set that smooth() has returned.
  void go_on(DartProposal set) { set_ = std::move(set); }

  const DartProposal& set() const { return set_; }

 private:
  struct CutSet {
    DartProposal set;
    SurfaceLines lines;
    FlatPieces pieces;
    std::vector<int> faces;  // input face that contains each face of the cut mesh
  };

  CutSet set_along(SurfaceLines lines) const;
  void keep_lines(SurfaceLines lines, const FlatPieces& pieces);

  const PieceToCut& piece_;
  const MergeRules rules_;
  const CutOptions& cut_options_;
  const ExactEvaluation& exact_;
  const ExactEvaluation unstopped_;  // completes the last set if the caller cancels
  DartProposal set_;
  SurfaceLines lines_;  // lines of set_
  int num_narrow_ = 0;
};

}  // namespace wirewarp
