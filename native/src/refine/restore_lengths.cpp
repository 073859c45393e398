// SPDX-License-Identifier: GPL-3.0-or-later
#include "refine/restore_lengths.h"

namespace wirewarp {
namespace {

constexpr double kExact = 1e-13;     // |c| / l
constexpr double kRounding = 1e-11;  // what short edges far from the origin can leave
constexpr int kMaxSteps = 10;

}  // namespace

bool restore_lengths(const LengthConstraints& constraints, const NewtonSystem& system, const Eigen::VectorXd& variation,
                     Positions2& uv) {
  Eigen::VectorXd residual = constraints.residual(uv, variation);
  double error = constraints.largest_error(residual);
  for (int i = 0; i < kMaxSteps && error > kExact; ++i) {
    const Positions2 trial = uv + system.least_change(-residual);
    const Eigen::VectorXd trial_residual = constraints.residual(trial, variation);
    const double trial_error = constraints.largest_error(trial_residual);
    if (!(trial_error < 0.5 * error)) break;
    uv = trial;
    residual = trial_residual;
    error = trial_error;
  }
  return error < kRounding;
}

}  // namespace wirewarp
