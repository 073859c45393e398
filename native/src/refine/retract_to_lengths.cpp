// SPDX-License-Identifier: GPL-3.0-or-later
#include "refine/retract_to_lengths.h"

#include <utility>

namespace wirewarp {
namespace {

constexpr int kMaxSteps = 60;         // a few substitutions each; ordinary pieces take three to five, slow ones arrive
constexpr double kSlowestFall = 0.9;  // of the error by a step: with half of it, 5 % more factorizations

}  // namespace

bool retract_to_lengths(const LengthConstraints& constraints, const NewtonSystem& system,
                        const Eigen::VectorXd& variation, Positions2& uv) {
  Eigen::VectorXd moved = Eigen::VectorXd::Zero(uv.size());  // on the wires: steps need no more
  Eigen::VectorXd residual = constraints.residual(uv, variation);
  double error = constraints.largest_error(residual);
  for (int i = 0; i < kMaxSteps && error > LengthConstraints::exact; ++i) {
    Eigen::VectorXd trial = moved + system.least_change(-residual);
    Eigen::VectorXd trial_residual =
        constraints.residual(uv + Eigen::Map<const Positions2>(trial.data(), uv.rows(), 2), variation);
    const double trial_error = constraints.largest_error(trial_residual);
    if (!(trial_error < kSlowestFall * error)) break;
    moved = std::move(trial);
    residual = std::move(trial_residual);
    error = trial_error;
  }
  if (error > LengthConstraints::kept) return false;
  uv += system.finish(moved);
  return true;
}

}  // namespace wirewarp
