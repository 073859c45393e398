// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "energy/length_constraints.h"
#include "newton/refine_shape.h"

namespace wirewarp {

/// A shape with the length variations of its elastic parts, and its f.
struct RefineIterate {
  Positions2 uv;              // one row per chart vertex
  Eigen::VectorXd variation;  // h, one per elastic part of the constraints
  double value = 0;           // f
};

/// min f(u) subject to c(u, h) = 0, |h| <= ε, on one chart.
class RefineProblem {
 public:
  /// layout: any of the chart, which says how large it is. The chart must outlive the problem.
  RefineProblem(const RefineTask& task, Injectivity injectivity, const Positions2& layout);

  const LengthConstraints& constraints() const { return constraints_; }
  const FairShapeError& objective() const { return objective_; }
  FairShapeError& objective() { return objective_; }

  /// The layout with the length variations it has, moved into their tolerances.
  RefineIterate iterate_at(const Positions2& uv) const;

  double length_error(const RefineIterate& iterate) const;
  bool is_isometric(const RefineIterate& iterate) const { return iterate.value <= isometric_value_; }

  /// Predicted decrease of f that a step from an iterate must have.
  double worthwhile_decrease(const RefineIterate& iterate) const;

  /// Without multipliers, and how it was reached.
  RefinedShape describe(const RefineIterate& iterate) const;

 private:
  const Chart& chart_;
  LengthConstraints constraints_;
  FairShapeError objective_;
  double worthwhile_;       // predicted decrease of f that a step must have, over f
  double isometric_value_;  // f, below which a layout is isometric but for rounding
};

}  // namespace wirewarp
