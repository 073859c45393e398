// SPDX-License-Identifier: GPL-3.0-or-later
// Solves a coupled group, usually of one chart, in any stage: from the shapes of the previous stage, finds all shapes
// and the common lengths of elastic seams at once (newton/refine_coupled.h).
//
// This fails if no common lengths are found, or if a chart becomes flipped or overlaps itself although all charts were
// good before, because good pieces matter more than less distortion. Then the stages solve each chart alone, with its
// elastic seams fixed at h = ease.
#pragma once

#include <functional>
#include <vector>

#include "energy/target_lengths.h"
#include "newton/solution.h"
#include "newton/solve/solve_chart.h"
#include "newton/solved_chart.h"

namespace wirewarp {

/// A chart of a coupled group in a stage.
struct GroupMember {
  Chart& chart;
  SolvedChart& solved;    // its layout from the previous stage, upright if there is a fabric
  bool is_nominal;        // the group has elastic seams, and this chart can be solved with its seams at h = ease
  TargetLengths lengths;  // used if there is a fabric
};

class GroupSolver {
 public:
  /// Searches for an injective shape of a chart that is flipped or overlaps itself, with its elastic seams fixed at the
  /// common lengths. The solution may be inexact or not injective; the caller checks.
  using RefineInjective = std::function<Solution(std::size_t member, const Chart& fixed, Budget& budget)>;

  struct Outcome {
    bool is_solved = false;            // if false, the shapes from before the stage are kept
    bool ran_out = false;              // the limit of factorizations ended a solver
    std::vector<char> is_folded = {};  // per chart, if solved: flipped or overlapping
  };

  /// renews_limit: whether each attempt may spend Options::max_factorizations, however many a chart spent before.
  GroupSolver(const std::vector<GroupMember>& group, const Run& run, const StopToken& stop, bool renews_limit,
              RefineInjective refine_injective);

  /// Finds the common lengths and the shapes. Keeps the shapes from before if all charts are nominal and a chart is
  /// folded although no chart was folded before.
  Outcome solve_together();

  /// Solves a chart alone. fixed: the chart with its elastic seams at h = ease.
  Outcome solve_alone(std::size_t member, const Chart& fixed) { return solve({{member, fixed}}, false); }

  /// Returns the chart as it was before the stage.
  const SolvedChart& before(std::size_t member) const { return before_[member]; }

 private:
  /// A chart of the group, perhaps with fixed seams.
  struct Part {
    std::size_t member;
    const Chart& chart;
  };

  SolvedChart& solved(const Part& part) const { return group_[part.member].solved; }
  Outcome solve(const std::vector<Part>& parts, bool keeps_good);
  bool take_common_shapes(const std::vector<Part>& parts, Budget& budget);
  bool replace_folded(const Part& part, Budget& budget);
  std::vector<char> find_folded(const std::vector<Part>& parts) const;
  bool were_good(const std::vector<Part>& parts) const;

  const std::vector<GroupMember>& group_;
  const Run& run_;
  const StopToken stop_;
  const bool renews_limit_;
  const RefineInjective refine_injective_;
  std::vector<SolvedChart> before_;
};

/// Returns whether a layout is flipped or overlaps itself.
bool has_folds(const Chart& chart, const Positions2& uv);

}  // namespace wirewarp
