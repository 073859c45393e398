// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/trust_region.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "newton/newton_constants.h"

namespace wirewarp {
namespace {

/// Returns the elastic parts, except parts at a bound that a decrease of f would push beyond the bound. f falls by
/// (Tᵀλ)_w per unit of h_w.
std::vector<int> free_parts(const NewtonState& state) {
  const LengthConstraints& constraints = state.constraints;
  const Eigen::VectorXd pull = constraints.elastic_lengths().transpose() * state.multipliers;
  std::vector<int> free;
  for (int w = 0; w < constraints.num_elastic(); ++w) {
    if (!constraints.is_at_bound(w, state.now.variation[w], pull[w])) free.push_back(w);
  }
  return free;
}

/// Returns the forces of the wires at the vertices, rotated by 90 degrees. At a saddle, the direction of descent may
/// break a symmetry that the gradient has. Then the gradient does not lead to this direction, but the rotated forces
/// do, because they break the symmetry, too.
Positions2 forces_across_symmetry(const NewtonState& state) {
  Positions2 tension = Positions2::Zero(state.now.uv.rows(), 2), turned(tension.rows(), 2);
  state.constraints.add_transposed(state.system->directions(), state.multipliers, tension);
  turned.col(0) = -tension.col(1);
  turned.col(1) = tension.col(0);
  return turned;
}

}  // namespace

StepOutcome TrustRegion::take_step(NewtonState& state) {
  if (!state.factorize(kConvexHessian)) return StepOutcome::rejected;
  const LengthConstraints& constraints = state.constraints;
  state.multipliers =
      state.system->solve_on_wires(-state.gradient, Eigen::VectorXd::Zero(constraints.size())).multipliers;
  const TangentSpace space(*state.system, constraints, free_parts(state));
  const Eigen::SparseMatrix<double> hessian = state.system->hessian(state.now.uv, state.multipliers, kExactHessian);
  const auto times_hessian = [&](const Eigen::VectorXd& x) -> Eigen::VectorXd {
    Eigen::VectorXd y = Eigen::VectorXd::Zero(x.size());
    y.head(hessian.rows()) = hessian.selfadjointView<Eigen::Lower>() * x.head(hessian.rows());
    return y;
  };
  const auto precondition = [&](Eigen::VectorXd& force) { return space.solve(force); };
  const auto model_for = [&](const Positions2& gradient) {
    return LanczosTrustRegion(times_hessian, precondition, space.force_on_vertices(gradient),
                              NewtonConstants::max_krylov_size);
  };
  const LanczosTrustRegion model = model_for(state.gradient);
  if (radius_ == 0) radius_ = model.convex_length();
  const bool is_stationary = model.convex_length() * model.convex_length() < state.worthwhile_decrease();
  if (!is_stationary) return search(state, space, [&](double radius) { return model.step(radius); });
  const LanczosTrustRegion off_saddle = model_for(forces_across_symmetry(state));
  if (off_saddle.lowest_curvature() > -NewtonConstants::flat_curvature) return StepOutcome::converged;
  // The gradient has almost vanished, so it does not define a step length. The radius must be large enough for a
  // worthwhile decrease.
  radius_ = std::max(radius_, std::sqrt(2 * state.worthwhile_decrease() / -off_saddle.lowest_curvature()));
  return search(state, space, [&](double radius) { return off_saddle.step_along_lowest_curvature(radius); });
}

/// Shrinks the radius until f falls as the model predicts, or doubles it as long as f falls further. Takes the step
/// with the lowest f. Returns rejected if f never falls as predicted.
StepOutcome TrustRegion::search(NewtonState& state, const TangentSpace& space,
                                const std::function<ModelStep(double radius)>& step_of) {
  std::optional<Iterate> best;
  double best_radius = 0;
  for (int i = 0; i < NewtonConstants::max_radii && (i == 0 || state.control.stop.may_go_on()); ++i) {
    const ModelStep step = step_of(radius_);
    Iterate trial = state.now;
    trial.uv += Eigen::Map<const Positions2>(step.d.data(), trial.uv.rows(), 2);
    trial.variation(space.free()) += step.d.tail(static_cast<Eigen::Index>(space.free().size()));
    const double ratio = state.evaluate(trial) ? (state.now.value - trial.value) / step.decrease : -1;
    if (ratio > NewtonConstants::accept_ratio && (!best || trial.value < best->value)) {
      best = std::move(trial);
      best_radius = radius_;
      was_inside_ = step.is_inside;
      if (ratio < NewtonConstants::grow_ratio || step.is_inside) break;
      radius_ *= 2;
    } else if (best) {
      break;
    } else {
      radius_ = std::min(radius_, step.length) / NewtonConstants::shrink;
    }
  }
  if (!best) return StepOutcome::rejected;
  radius_ = best_radius;
  state.now = std::move(*best);
  return StepOutcome::accepted;
}

}  // namespace wirewarp
