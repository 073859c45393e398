// SPDX-License-Identifier: GPL-3.0-or-later
#include "refine/restore_lengths.h"

namespace wirewarp {
namespace {

constexpr int kMaxSteps = 10;

}  // namespace

/// The steps need the wires alone; all other vertices follow in one step at the end, by the sum of what was missing.
bool restore_lengths(const LengthConstraints& constraints, const NewtonSystem& system, const Eigen::VectorXd& variation,
                     Positions2& uv) {
  using Where = NewtonSystem::Where;
  Positions2 on_wires = uv;
  Eigen::VectorXd residual = constraints.residual(uv, variation);
  Eigen::VectorXd restored = Eigen::VectorXd::Zero(constraints.size());
  double error = constraints.largest_error(residual);
  for (int i = 0; i < kMaxSteps && error > LengthConstraints::exact; ++i) {
    const Positions2 trial = on_wires + system.least_change(-residual, Where::on_wires);
    const Eigen::VectorXd trial_residual = constraints.residual(trial, variation);
    const double trial_error = constraints.largest_error(trial_residual);
    if (!(trial_error < 0.5 * error)) break;
    on_wires = trial;
    restored += residual;
    residual = trial_residual;
    error = trial_error;
  }
  if (error > LengthConstraints::kept) return false;
  uv += system.least_change(-restored, Where::everywhere);
  for (const LengthConstraints::Edge& edge : constraints.edges()) {
    for (const int v : {edge.a, edge.b}) uv.row(v) = on_wires.row(v);
  }
  return true;
}

}  // namespace wirewarp
