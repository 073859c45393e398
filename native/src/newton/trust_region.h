// SPDX-License-Identifier: GPL-3.0-or-later
// The step of minimize() where the exact Hessian is not positive: the quadratic model of f + λᵀc, minimized within a
// radius (newton/lanczos_trust_region.h). The radius carries over from step to step.
#pragma once

#include <functional>

#include "newton/lanczos_trust_region.h"
#include "newton/newton_state.h"
#include "newton/tangent_space.h"

namespace wirewarp {

class TrustRegion {
 public:
  /// From exact lengths to exact lengths, downhill. Converged where no gradient is left, and no way down from a saddle.
  StepOutcome take_step(NewtonState& state);

  /// Whether the radius did not hold back the last step: the exact Hessian may be positive where it ends.
  bool was_inside() const { return was_inside_; }

 private:
  StepOutcome search(NewtonState& state, const TangentSpace& space,
                     const std::function<ModelStep(double radius)>& step_of);

  double radius_ = 0;  // in the metric of the convex part of the Hessian; 0: not chosen yet
  bool was_inside_ = false;
};

}  // namespace wirewarp
