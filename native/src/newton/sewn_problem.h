// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "newton/refine_shape.h"
#include "surface/charts/slits.h"

namespace wirewarp {

/// A chart to refine with some slits sewn, and the way to and from it.
class SewnProblem {
 public:
  SewnProblem(const RefineTask& open, SewnChart sewn);

  /// Refers to this problem.
  RefineTask task() const { return {sewn_.chart, network_, fairness_, cloth_ ? &*cloth_ : nullptr, target_}; }

  /// Edges that are sewn together bear the forces of both.
  RefinementStart to_sewn(const RefinementStart& open) const;

  RefinementStart to_open(const RefinedShape& sewn) const;

  /// A shape of this problem as one of the open chart. open: the task this was made of.
  RefinedShape as_open(const RefineTask& open, const RefinedShape& sewn) const;

 private:
  SewnChart sewn_;
  HeldNetwork network_;
  double fairness_;
  Target target_;
  std::optional<ClothOnChart> cloth_;
  std::vector<int> row_;  // of the sewn constraints, one per row of the open ones
  int num_rows_;          // of the sewn constraints
};

}  // namespace wirewarp
