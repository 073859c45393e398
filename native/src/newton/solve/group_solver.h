// SPDX-License-Identifier: GPL-3.0-or-later
// Solves a coupled group, usually of one chart, in any stage. Starts with the shapes of the previous stage, and finds
// all shapes and the common lengths of elastic seams at once (newton/refine_coupled.h).
//
// This fails if no common lengths are found, or if a chart becomes flipped or overlaps itself although all charts were
// good before. Good pieces matter more than less distortion. After a failure, the stages solve each chart alone, with
// its elastic seams fixed at h = ease.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "energy/target_lengths.h"
#include "newton/solution.h"
#include "newton/solve/solve_chart.h"
#include "newton/solved_chart.h"

namespace wirewarp {

struct GroupMember {
  Chart& chart;
  SolvedChart& solved;    // its layout from the previous stage, upright if there is a fabric
  bool is_nominal;        // whether the chart has elastic seams and can be solved with these fixed at h = ease
  TargetLengths lengths;  // used if there is a fabric
};

class GroupSolver {
 public:
  /// Searches for an injective shape of a chart that is flipped or overlaps itself. Its elastic seams are fixed at the
  /// common lengths. The caller checks the solution.
  using RefineInjective = std::function<Solution(std::size_t member, Budget& budget)>;

  struct Outcome {
    bool is_solved = false;            // if false, the shapes from before the stage are kept
    bool ran_out = false;              // whether the limit of factorizations ended a solver
    std::vector<char> is_folded = {};  // per chart, if solved: whether it is flipped or overlapping
  };

  /// renews_limit: whether each attempt may spend Options::max_factorizations, whatever a chart spent before.
  GroupSolver(const std::vector<GroupMember>& group, const Run& run, const StopToken& stop, bool renews_limit,
              RefineInjective refine_injective);

  /// Finds the common lengths and shapes of all charts, or only the shape of the chart `alone`. Keeps all earlier
  /// shapes if two conditions hold:
  ///
  /// - A chart becomes flipped or overlaps itself, and RefineInjective does not help.
  /// - Every chart is nominal and was good before.
  Outcome solve(std::optional<std::size_t> alone = std::nullopt);

  /// Returns the chart as it was before the stage.
  const SolvedChart& before(std::size_t member) const { return before_[member]; }

  /// Returns whether the chart was neither flipped nor overlapping before the stage.
  bool was_good(std::size_t member) const;

 private:
  bool take_common_shapes(const std::vector<std::size_t>& members, Budget& budget);
  bool replace_folded(std::size_t member, Budget& budget);

  const std::vector<GroupMember>& group_;
  const Run& run_;
  const StopToken stop_;
  const bool renews_limit_;
  const RefineInjective refine_injective_;
  std::vector<SolvedChart> before_;
};

/// Sets the layout of a chart and the lengths of its wires to a new shape.
void take_shape(Shape& shape, const GroupMember& member);

}  // namespace wirewarp
