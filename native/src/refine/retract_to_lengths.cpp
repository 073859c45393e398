// SPDX-License-Identifier: GPL-3.0-or-later
#include "refine/retract_to_lengths.h"

#include <Eigen/QR>
#include <deque>

namespace wirewarp {
namespace {

constexpr int kMaxSteps = 30;
constexpr std::size_t kMemory = 5;  // steps

/// What to take off next, of residuals c of which steps take off about as much as they are fed: Anderson's
/// acceleration (D. G. Anderson, Iterative procedures for nonlinear integral equations, Journal of the ACM 12, 1965).
/// First as much of the steps so far as leaves, by what they did, the least residual; then that.
class AcceleratedSteps {
 public:
  Eigen::VectorXd next(const Eigen::VectorXd& residual) const {
    if (changes_.empty()) return residual;
    Eigen::MatrixXd changes(residual.size(), static_cast<Eigen::Index>(changes_.size())), fed = changes;
    for (std::size_t i = 0; i < changes_.size(); ++i) {
      changes.col(static_cast<Eigen::Index>(i)) = changes_[i];
      fed.col(static_cast<Eigen::Index>(i)) = fed_[i];
    }
    const Eigen::VectorXd shares = changes.colPivHouseholderQr().solve(residual);
    return residual - (changes + fed) * shares;
  }

  void remember(Eigen::VectorXd fed, Eigen::VectorXd change) {
    if (fed_.size() == kMemory) {
      fed_.pop_front();
      changes_.pop_front();
    }
    fed_.push_back(std::move(fed));
    changes_.push_back(std::move(change));
  }

  bool is_plain() const { return fed_.empty(); }

 private:
  std::deque<Eigen::VectorXd> fed_, changes_;
};

}  // namespace

bool retract_to_lengths(const LengthConstraints& constraints, const NewtonSystem& system,
                        const Eigen::VectorXd& variation, Positions2& uv) {
  Eigen::VectorXd moved = Eigen::VectorXd::Zero(uv.size());  // on the wires: steps need no more
  Eigen::VectorXd residual = constraints.residual(uv, variation);
  double error = constraints.largest_error(residual);
  AcceleratedSteps steps;
  for (int i = 0; i < kMaxSteps && error > LengthConstraints::exact; ++i) {
    Eigen::VectorXd feed = steps.next(residual);
    Eigen::VectorXd trial = moved + system.least_change(-feed);
    Eigen::VectorXd trial_residual =
        constraints.residual(uv + Eigen::Map<const Positions2>(trial.data(), uv.rows(), 2), variation);
    const double trial_error = constraints.largest_error(trial_residual);
    if (trial_error < 0.5 * error) {
      steps.remember(std::move(feed), trial_residual - residual);
      moved = std::move(trial);
      residual = std::move(trial_residual);
      error = trial_error;
    } else if (steps.is_plain() || error <= LengthConstraints::kept) {  // too far away, or rounding
      break;
    } else {
      steps = {};
    }
  }
  if (error > LengthConstraints::kept) return false;
  uv += system.finish(moved);
  return true;
}

}  // namespace wirewarp
