// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/retract_to_lengths.h"

#include <Eigen/QR>
#include <array>
#include <utility>

namespace wirewarp {
namespace {

constexpr int kOrdinarySteps = 5;  // the token is polled once per this many steps
constexpr int kMaxSteps = 60;      // with 30, some nets stop at errors of 1e-11
constexpr int kRemembered = 5;     // number of previous steps; nets of 128 wires take 10% longer with 3
constexpr double kMostLeft = 0.9;  // largest share of the error that a step leaves; 0.45 costs 5% more factorizations

/// Anderson acceleration: finds the combination of previous steps that minimizes the linearly extrapolated error.
class StepsBefore {
 public:
  bool is_empty() const { return size_ == 0; }

  void add(const Eigen::VectorXd& step, const Eigen::VectorXd& change) {
    if (size_ < kRemembered) ++size_;
    steps_[next_] = step;
    changes_[next_] = change;
    next_ = (next_ + 1) % kRemembered;
  }

  /// Moves by the best combination of steps, and changes the residual as if it were linear.
  void extrapolate(Eigen::VectorXd& moved, Eigen::VectorXd& residual) const {
    if (is_empty()) return;
    Eigen::MatrixXd changes(residual.size(), size_);
    for (int i = 0; i < size_; ++i) changes.col(i) = changes_[i];
    const Eigen::VectorXd shares = changes.colPivHouseholderQr().solve(residual);
    residual -= changes * shares;
    for (int i = 0; i < size_; ++i) moved -= shares[i] * steps_[i];
  }

 private:
  std::array<Eigen::VectorXd, kRemembered> steps_, changes_;
  int size_ = 0, next_ = 0;
};

}  // namespace

bool retract_to_lengths(const LengthConstraints& constraints, const NewtonSystem& system,
                        const Eigen::VectorXd& variation, Positions2& uv, const StopToken& stop) {
  Eigen::VectorXd moved = Eigen::VectorXd::Zero(system.num_unknowns());  // on the wires only
  Eigen::VectorXd residual = constraints.residual(uv, variation);
  double error = constraints.largest_error(residual);
  StepsBefore before;
  for (int i = 0; i < kMaxSteps && error > LengthConstraints::exact; ++i) {
    if (i % kOrdinarySteps == kOrdinarySteps - 1 && !stop.may_go_on()) return false;
    Eigen::VectorXd trial = moved, expected = residual;
    before.extrapolate(trial, expected);
    trial += system.least_change(-expected);
    Eigen::VectorXd trial_residual =
        constraints.residual(uv + Eigen::Map<const Positions2>(trial.data(), uv.rows(), 2), variation);
    const double trial_error = constraints.largest_error(trial_residual);
    if (!(trial_error < kMostLeft * error)) {
      if (before.is_empty()) break;
      before = {};  // the extrapolation went too far; a plain step may still reduce the error
      continue;
    }
    before.add(trial - moved, trial_residual - residual);
    moved = std::move(trial);
    residual = std::move(trial_residual);
    error = trial_error;
  }
  if (error > LengthConstraints::kept) return false;
  uv += system.finish(moved);
  return true;
}

}  // namespace wirewarp
