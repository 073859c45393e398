// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/project_to_lengths.h"

#include <cmath>
#include <utility>

#include "newton/newton_system.h"
#include "numerics/optimize/box_quadratic.h"

namespace wirewarp {
namespace {

// Largest number of steps with one factor. Each step after the first halves the strain, so nine of them leave 1/500.
constexpr int kMaxProjectSteps = 10;
constexpr double kShortestProjectStep = 1.0 / 64;  // shorter steps do not reduce the length errors
constexpr double kSufficientProjectStep = 0.1;     // a step must achieve this share of the predicted decrease

struct Projected {
  Positions2 uv;
  Eigen::VectorXd variation;  // h of elastic parts
  Eigen::VectorXd residual;   // c
};

/// Minimizes the strain of springs ρ along the edges by Gauss-Newton steps, which are shortest in the metric H. With d
/// eliminated, a quadratic program in Δh keeps h within its tolerances.
class Projection {
 public:
  Projection(const Problem& problem, const Positions2& uv, const StopToken& stop)
      : constraints_(problem.constraints({})),
        objective_(problem.objective({})),
        system_(problem.chart(), objective_, constraints_, uv, stop),
        lengths_(constraints_.elastic_lengths()),
        now_(at(uv, constraints_.variation(uv))) {}

  const Positions2& uv() const { return now_.uv; }
  bool has(double largest_error) const { return constraints_.largest_error(now_.residual) <= largest_error; }

  /// Takes one step, shortened until the strain falls. Then takes whole steps with the same factor as long as each step
  /// halves the strain. Returns false if no step reduces the strain.
  bool get_nearer(const StopToken& stop) {
    const Eigen::VectorXd no_forces = Eigen::VectorXd::Zero(constraints_.size());
    const bool is_positive = system_.factorize(now_.uv, no_forces, kLaplacian, stop);
    stop.check();
    if (!is_positive) return false;
    const Projected far = moved();
    double t = 1;
    Projected next = far;
    while (!(strain(next) <= (1 - kSufficientProjectStep * t) * strain(now_))) {
      t /= 2;
      if (t < kShortestProjectStep) return false;
      next = at(now_.uv + t * (far.uv - now_.uv), now_.variation + t * (far.variation - now_.variation));
    }
    now_ = std::move(next);
    for (int k = 1; k < kMaxProjectSteps && !has(LengthConstraints::exact); ++k) {
      Projected nearer = moved();
      if (!(strain(nearer) < 0.5 * strain(now_))) break;
      now_ = std::move(nearer);
    }
    return true;
  }

 private:
  Projected at(const Positions2& uv, const Eigen::VectorXd& variation) const {
    Projected iterate{uv, constraints_.within_tolerance(variation), {}};
    iterate.residual = constraints_.residual(uv, iterate.variation);
    return iterate;
  }

  double strain(const Projected& iterate) const {
    return std::sqrt(iterate.residual.cwiseAbs2().dot(system_.stiffness()));
  }

  /// Returns the iterate after a whole step.
  Projected moved() const {
    Eigen::VectorXd d = system_.least_change(-now_.residual);
    Eigen::VectorXd change = Eigen::VectorXd::Zero(constraints_.num_elastic());
    if (change.size() > 0) {
      const Eigen::Map<const Positions2> d_by_vertex(d.data(), now_.uv.rows(), 2);
      const Eigen::VectorXd left = now_.residual + constraints_.apply(system_.directions(), d_by_vertex);
      change = minimize_quadratic_in_box(-(lengths_.transpose() * system_.stiffness().cwiseProduct(left)),
                                         system_.stiffness_by_variation(), -constraints_.tolerance() - now_.variation,
                                         constraints_.tolerance() - now_.variation);
      d += system_.least_change(lengths_ * change);
    }
    return at(now_.uv + system_.finish(d), now_.variation + change);
  }

  LengthConstraints constraints_;
  FairShapeError objective_;
  NewtonSystem system_;
  const Eigen::SparseMatrix<double>& lengths_;  // T
  Projected now_;
};

}  // namespace

bool project_to_lengths(const Problem& problem, Positions2& uv, const Control& control) {
  Projection projection(problem, uv, control.stop);
  while (!projection.has(LengthConstraints::exact) && control.budget.allows()) {
    control.budget.spend(1);
    if (!projection.get_nearer(control.stop)) break;
  }
  uv = projection.uv();
  return projection.has(LengthConstraints::kept);
}

}  // namespace wirewarp
