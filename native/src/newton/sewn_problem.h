// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "newton/control.h"
#include "newton/problem.h"
#include "newton/solution.h"
#include "surface/charts/slits.h"

namespace wirewarp {

/// A problem and a stage with some slits sewn.
class SewnProblem {
 public:
  /// The open problem and the objects to which the stage points must outlive this object.
  SewnProblem(const Problem& open, const Stage& stage, SewnChart sewn);
  SewnProblem(const SewnProblem&) = delete;  // not copied, because the problem refers to the chart
  SewnProblem& operator=(const SewnProblem&) = delete;

  Problem& problem() { return problem_; }

  /// Minimizes from a shape of the open problem, with the slits sewn, and returns a solution of the open problem.
  Solution minimize(const Shape& start, const Control& control) const;

  /// Converts a solution to the open problem. The multiplier of a sewn edge is divided between its two sides.
  Solution as_open(const Solution& sewn) const;

 private:
  const Problem& open_;
  Stage stage_;  // stage of the open problem
  SewnChart sewn_;
  Problem problem_;
  std::optional<TargetLengths> lengths_;
  std::vector<int> row_;  // row of the sewn constraints for each row of the open constraints
  int num_rows_;          // number of rows of the sewn constraints
};

/// Returns the problem with these slits sewn, or null if the sewn surface is not a chart.
std::unique_ptr<SewnProblem> sew_slits(const Problem& open, const Stage& stage, const std::vector<Slit>& slits);

}  // namespace wirewarp
