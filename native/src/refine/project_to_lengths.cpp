// SPDX-License-Identifier: GPL-3.0-or-later
#include "refine/project_to_lengths.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <utility>

#include "network/length_variation.h"
#include "refine/newton_system.h"

namespace wirewarp {
namespace {

constexpr int kMaxFactorizations = 5;
constexpr int kMaxSteps = 10;  // with one factor

/// The least change for given residuals, Δh among it: springs ρ pull at d and Δh alike, and d is eliminated.
class LeastChange {
 public:
  LeastChange(const LengthConstraints& constraints, const NewtonSystem& system)
      : constraints_(constraints), system_(system), lengths_(constraints.elastic_lengths()) {
    if (constraints.num_elastic() > 0) by_variation_.compute(system.stiffness_by_variation());
  }

  void step(const Eigen::VectorXd& residual, Positions2& uv, Eigen::VectorXd& variation) const {
    Eigen::VectorXd d = system_.least_change(-residual);
    if (variation.size() > 0) {
      const Eigen::VectorXd left =
          residual + constraints_.apply(system_.directions(), Eigen::Map<const Positions2>(d.data(), uv.rows(), 2));
      const Eigen::VectorXd change = by_variation_.solve(lengths_.transpose() * system_.stiffness().cwiseProduct(left));
      d += system_.least_change(lengths_ * change);
      variation += change;
    }
    uv += system_.finish(d);
  }

 private:
  const LengthConstraints& constraints_;
  const NewtonSystem& system_;
  const Eigen::SparseMatrix<double>& lengths_;  // T
  Eigen::LDLT<Eigen::MatrixXd> by_variation_;
};

bool is_within_tolerance(const Chart& chart, const LengthConstraints& constraints, const Eigen::VectorXd& variation) {
  for (int w = 0; w < variation.size(); ++w) {
    if (std::abs(variation[w]) > chart.wire_parts[constraints.elastic_parts()[w]].tolerance) return false;
  }
  return true;
}

}  // namespace

bool project_to_lengths(const Chart& chart, const WireNetwork& network, double fairness, Positions2& uv,
                        const std::function<bool()>& go_on) {
  const LengthConstraints constraints(chart, network);
  FairShapeError objective(chart, network, fairness);
  NewtonSystem system(chart, objective, constraints, uv);
  Eigen::VectorXd variation = length_variation(chart, uv)(constraints.elastic_parts());
  const Eigen::VectorXd no_forces = Eigen::VectorXd::Zero(constraints.size());
  double error = constraints.largest_error(constraints.residual(uv, variation));
  for (int i = 0; i < kMaxFactorizations && error > LengthConstraints::exact && go_on(); ++i) {
    if (!system.factorize(uv, no_forces, {Curvature::none, false})) return false;
    const LeastChange least_change(constraints, system);
    for (int k = 0; k < kMaxSteps && error > LengthConstraints::exact; ++k) {
      Positions2 trial = uv;
      Eigen::VectorXd trial_variation = variation;
      least_change.step(constraints.residual(uv, variation), trial, trial_variation);
      const double trial_error = constraints.largest_error(constraints.residual(trial, trial_variation));
      if (!(trial_error < 0.5 * error)) break;
      uv = std::move(trial);
      variation = std::move(trial_variation);
      error = trial_error;
    }
  }
  return error <= LengthConstraints::kept && is_within_tolerance(chart, constraints, variation);
}

}  // namespace wirewarp
