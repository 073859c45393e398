// SPDX-License-Identifier: GPL-3.0-or-later
#include "refine/retract_to_lengths.h"

#include <utility>

namespace wirewarp {
namespace {

constexpr int kOrdinarySteps = 5;  // at most; those that take more ask whether to go on
constexpr int kMaxSteps = 60;      // with 30 some nets stop at 1e-11
constexpr double kMostLeft = 0.9;  // of the error after a step: with 0.45, 5 % more factorizations

}  // namespace

bool retract_to_lengths(const LengthConstraints& constraints, const NewtonSystem& system,
                        const Eigen::VectorXd& variation, Positions2& uv, const StopToken& stop) {
  Eigen::VectorXd moved = Eigen::VectorXd::Zero(system.num_unknowns());  // on the wires: steps need no more
  Eigen::VectorXd residual = constraints.residual(uv, variation);
  double error = constraints.largest_error(residual);
  for (int i = 0; i < kMaxSteps && error > LengthConstraints::exact; ++i) {
    if (i % kOrdinarySteps == kOrdinarySteps - 1 && !stop.may_go_on()) return false;
    Eigen::VectorXd trial = moved + system.least_change(-residual);
    Eigen::VectorXd trial_residual =
        constraints.residual(uv + Eigen::Map<const Positions2>(trial.data(), uv.rows(), 2), variation);
    const double trial_error = constraints.largest_error(trial_residual);
    if (!(trial_error < kMostLeft * error)) break;
    moved = std::move(trial);
    residual = std::move(trial_residual);
    error = trial_error;
  }
  if (error > LengthConstraints::kept) return false;
  uv += system.finish(moved);
  return true;
}

}  // namespace wirewarp
