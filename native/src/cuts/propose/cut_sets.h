// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "cuts/feasibility/cut_mask.h"
#include "cuts/feasibility/mirrored_cuts.h"
#include "cuts/feasibility/part_map.h"
#include "cuts/propose/cut_progress.h"
#include "cuts/propose/flat_pieces.h"
#include "surface/charts/chart.h"
#include "wirewarp/propose.h"

namespace wirewarp {

/// The largest strain that woven fabric allows. By default, pieces with at most this strain are not cut again.
constexpr double kTargetStrain = 0.05;

/// The largest strain that plush allows. Sets along edges are merged up to about this strain or twice the target. Sets
/// for more strain are slow to find, and suit only stretchy knits.
constexpr double kSoftStrain = 0.2;

/// Returns up to three strains for merged sets: `least`, and then twice the strain before. If possible, the last strain
/// is near kSoftStrain, or near twice the target if this is larger.
std::vector<double> allowed_strains(double least, double target);

/// Drops each set if a shorter set has at most as many pieces and at most as much strain. Returns the other sets, the
/// longest first.
std::vector<DartProposal> without_worse(std::vector<DartProposal> sets);

/// Returns the strain that the fabric of a set must allow: the set's strain, rounded up to 1, 2, 4, … times the target.
/// By default, this is 5% (woven fabric), 10%, 20% (plush) and so on. Ignores an excess below kStrainError.
double limit_of_set(const DartProposal& set, const CutOptions& cut_options);

/// Returns up to cut_options.count sets, in their order. Prefers the first set, then the shortest set for each
/// limit_of_set(), and then the longest other sets. sets: the longest first.
std::vector<DartProposal> chosen_by_limit(const std::vector<DartProposal>& sets, const CutOptions& cut_options);

/// Largest number of cuts after the cut that makes the piece flat. A cut and its mirror image count as one.
struct MostCuts {
  /// If no strain is requested and the set has at most the strain of plush. A plush animal may get two cuts for each of
  /// its twenty parts.
  std::size_t for_plush = 40;
  /// Otherwise. After 80 cuts, smooth sets of a penguin, a koala and a camel need more than a requested 8%.
  std::size_t in_all = 160;
};

/// Searches for cut sets of a piece that has no flat shape or too much strain. First makes the piece flat, then
/// repeatedly cuts the most strained part, and finally merges pieces.
class CutSetSearch {
 public:
  /// piece: index of the piece to cut. All arguments except for most_cuts must outlive the object.
  CutSetSearch(const FlatPieces& pieces, std::size_t piece, const CutOptions& cut_options, const ExactEvaluation& exact,
               CutProgress& progress, const MostCuts& most_cuts = {});

  /// Returns the sets, the longest first; DartProposal::piece is not set. If canceled, returns the sets found so far.
  /// Throws no_proposal if there is no set, and Stopped if it is canceled before it finds a set.
  std::vector<DartProposal> search();

 private:
  struct CutSet {
    CutMask cut;
    FlatPieces pieces;  // all pieces of the input
    DartProposal proposal;
    bool lies_flat = false;
  };

  struct Candidate {
    CutMask cut;                 // symmetric if the piece is symmetric
    double gain = 0;             // share of the part's energy that the cut removes
    double gain_for_length = 0;  // gain divided by the length of the cut
  };

  CutMask opening() const;
  CutSet with_figures(CutMask cut, FlatPieces pieces) const;
  CutSet evaluate(const FlatPieces& before, const CutMask& cut) const;
  void report_strain(double first, double now);
  void report_merged(double num_done, std::size_t count);
  bool makes_narrow(const CutSet& more, const FlatPiece& part) const;
  std::size_t worst_part(const CutSet& set) const;
  std::optional<CutSet> cut_once_more(const CutSet& set) const;
  void add_more_cuts(std::vector<CutSet>& sets);
  void add_merged(std::vector<CutSet>& sets);
  bool add_smooth(std::vector<CutSet>& sets);
  std::vector<DartProposal> best_of(const std::vector<CutSet>& sets) const;
  void add_lines(const CutSet& set, std::size_t part, std::vector<Candidate>& found) const;
  void add_bisections(const CutSet& set, std::size_t part, std::vector<Candidate>& found) const;
  std::vector<CutMask> bisections_of(const Chart& part) const;

  const FlatPieces& pieces_;
  const std::size_t piece_;
  const Chart& input_chart_;
  const bool is_flat_;  // whether the piece has a flat shape without cuts
  const Chart chart_;   // in canonical order
  const PartMap map_;
  const std::vector<VertexHandle> image_;
  const MirroredCuts mirrored_;
  CutMask forbidden_;
  const CutOptions& cut_options_;
  const double target_;  // accepted strain
  const double fine_;    // accepted strain of sets along edges: for smooth sets, a requested strain over kFineGrowth
  const ExactEvaluation& exact_;
  CutProgress& progress_;
  const MostCuts most_cuts_;
};

}  // namespace wirewarp
