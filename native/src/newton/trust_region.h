// SPDX-License-Identifier: GPL-3.0-or-later
// The steps of minimize() if the exact Hessian is not positive. Each step minimizes the quadratic model of f + λᵀc
// within a radius (newton/lanczos_trust_region.h). The first radius to try is the radius of the step before.
#pragma once

#include <functional>

#include "newton/lanczos_trust_region.h"
#include "newton/newton_state.h"
#include "newton/tangent_space.h"

namespace wirewarp {

class TrustRegion {
 public:
  /// Takes a step that decreases f and keeps exact lengths. Returns converged if the gradient vanishes and
  /// f has no negative curvature worth following.
  StepOutcome take_step(NewtonState& state);

  /// Returns whether the last step was shorter than the radius. Then the exact Hessian may be positive after the step.
  bool was_inside() const { return was_inside_; }

 private:
  StepOutcome search(NewtonState& state, const TangentSpace& space,
                     const std::function<ModelStep(double radius)>& step_of);

  double radius_ = 0;  // in the metric of the convex part of the Hessian; 0: not chosen yet
  bool was_inside_ = false;
};

}  // namespace wirewarp
