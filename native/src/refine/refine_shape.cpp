// SPDX-License-Identifier: GPL-3.0-or-later
#include "refine/refine_shape.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "index.h"
#include "mesh/geometry.h"
#include "outer/active_set_bfgs.h"
#include "refine/tangent_model.h"

namespace wirewarp {
namespace {

constexpr double kNearlyExact = 1e-8;  // |c| / l, where phase 1 ends
constexpr double kExact = 1e-13;
constexpr double kWorthwhile = 1e-9;  // decrease that a step must promise, over f
constexpr double kSufficient = 1e-4;
constexpr double kSmallestStep = 1e-6;
constexpr int kMaxRestorations = 10;

constexpr Convexity kExactHessian{Curvature::exact, 1};
constexpr Convexity kConvexHessian{Curvature::convex, 0};
constexpr Convexity kLaplacian{Curvature::none, 0};

double env(const char* name, double d) { const char* v = std::getenv(name); return v ? atof(v) : d; }
bool verbose() { static const bool v = std::getenv("WW_VERBOSE") != nullptr; return v; }
double dot(const Positions2& a, const Positions2& b) { return (a.array() * b.array()).sum(); }

struct Step {
  Positions2 d;
  Eigen::VectorXd variation;    // Δh
  Eigen::VectorXd multipliers;  // λ of the step's problem
};

class Refinement {
 public:
  Refinement(const Chart& chart, const WireNetwork& network, double fairness)
      : area_(surface_area(chart.mesh)),
        constraints_(chart, network),
        objective_(chart, network, fairness),
        system_(chart, objective_, constraints_),
        elastic_lengths_(constraints_.elastic_lengths()) {
    tolerance_.resize(constraints_.num_elastic());
    for (int w = 0; w < constraints_.num_elastic(); ++w) {
      tolerance_[w] = chart.wire_parts[at(constraints_.elastic_parts()[at(w)])].tolerance;
    }
  }

  RefinedSolution run(const Positions2& start, int max_factorizations, const std::function<bool()>& go_on);

 private:
  bool reach_exact_lengths();
  void minimize();
  Step newton_step(const Positions2& gradient, const Eigen::VectorXd& residual) const;
  bool restore(Positions2& uv, const Eigen::VectorXd& variation) const;
  bool take_newton_step(const Positions2& gradient, bool& accepted);
  bool take_trust_region_step(const Positions2& gradient);
  bool may_go_on() const { return system_.num_factorizations() < max_factorizations_ && go_on_(); }

  double area_;
  LengthConstraints constraints_;
  FairShapeError objective_;
  NewtonSystem system_;
  Eigen::MatrixXd elastic_lengths_;  // T
  Eigen::VectorXd tolerance_;
  int max_factorizations_ = 0;
  std::function<bool()> go_on_;
  RefinedSolution now_;
  Eigen::VectorXd multipliers_;
  double radius_ = 0;
  bool is_positive_ = true;
};

/// The quadratic program of a step: d and Δh for the linearized lengths, Δh from the dense problem that is left when d
/// is eliminated.
Step Refinement::newton_step(const Positions2& gradient, const Eigen::VectorXd& residual) const {
  Step step;
  system_.solve(-gradient, -residual, step.d, step.multipliers);
  step.variation = Eigen::VectorXd::Zero(constraints_.num_elastic());
  if (constraints_.num_elastic() == 0) return step;
  Eigen::MatrixXd s = system_.hessian_by_variation();
  const Eigen::VectorXd g = -elastic_lengths_.transpose() * step.multipliers;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(s);
  const double floor = 1e-6 * eigen.eigenvalues().cwiseAbs().maxCoeff();
  const Eigen::VectorXd positive = eigen.eigenvalues().cwiseAbs().cwiseMax(floor);
  s = eigen.eigenvectors() * positive.asDiagonal() * eigen.eigenvectors().transpose();
  step.variation = minimize_model_in_box(g, s, -tolerance_ - now_.variation, tolerance_ - now_.variation);
  system_.solve(-gradient, elastic_lengths_ * step.variation - residual, step.d, step.multipliers);
  return step;
}

/// Brings c to 0 with the factor at hand; false where that is not nearly linear.
bool Refinement::restore(Positions2& uv, const Eigen::VectorXd& variation) const {
  Eigen::VectorXd residual = constraints_.residual(uv, variation);
  double error = constraints_.largest_error(residual);
  for (int i = 0; i < kMaxRestorations && error >= kExact; ++i) {
    const Positions2 trial = uv + system_.least_change(-residual);
    const Eigen::VectorXd trial_residual = constraints_.residual(trial, variation);
    const double trial_error = constraints_.largest_error(trial_residual);
    if (!(trial_error < 0.5 * error)) break;
    uv = trial;
    residual = trial_residual;
    error = trial_error;
  }
  return error < 100 * kExact;
}

bool Refinement::reach_exact_lengths() {
  const Eigen::VectorXd residual = constraints_.residual(now_.uv, now_.variation);
  if (constraints_.largest_error(residual) < kNearlyExact) return true;
  Positions2 gradient;
  objective_.value_and_gradient(now_.uv, gradient);
  if (!system_.factorize(now_.uv, multipliers_, kLaplacian)) return false;
  const Step step = newton_step(gradient, residual);
  Positions2 uv = now_.uv + step.d;
  const Eigen::VectorXd variation = now_.variation + step.variation;
  ++now_.iterations;
  if (!restore(uv, variation)) return false;
  now_.uv = std::move(uv);
  now_.variation = variation;
  multipliers_ = step.multipliers;
  return true;
}

/// True: the exact Hessian was positive.
bool Refinement::take_newton_step(const Positions2& gradient, bool& accepted) {
  accepted = false;
  if (!system_.factorize(now_.uv, multipliers_, kExactHessian)) return false;
  const Step step = newton_step(gradient, constraints_.residual(now_.uv, now_.variation));
  const double slope = dot(gradient, step.d);
  if (verbose()) printf("newton: f %.8g slope %.3g flips %d", now_.value, slope / now_.value, objective_.count_flips(now_.uv));
  now_.converged = -slope < kWorthwhile * now_.value;
  if (now_.converged) return true;
  for (double t = 1; t > env("TMIN", 0.4); t /= 2) {
    Positions2 uv = now_.uv + t * step.d;
    const Eigen::VectorXd variation = now_.variation + t * step.variation;
    if (!restore(uv, variation)) continue;
    const double value = objective_.value(uv);
    if (!(value <= now_.value + kSufficient * t * slope)) continue;
    now_.uv = std::move(uv);
    now_.variation = variation;
    now_.value = value;
    multipliers_ += t * (step.multipliers - multipliers_);
    accepted = true;
    if (verbose()) printf(" t %g\n", t);
    return true;
  }
  if (verbose()) printf(" rejected\n");
  return true;
}

bool Refinement::take_trust_region_step(const Positions2& gradient) {
  if (!system_.factorize(now_.uv, multipliers_, kConvexHessian)) return false;
  const Eigen::Index n = gradient.size();
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(constraints_.size());
  Positions2 d;
  system_.solve(-gradient, none, d, multipliers_);
  const Eigen::SparseMatrix<double> hessian = system_.hessian(now_.uv, multipliers_, kExactHessian);

  // Elastic parts that are not held at a bound.
  const Eigen::VectorXd by_variation = -elastic_lengths_.transpose() * multipliers_;
  std::vector<int> free;
  for (int w = 0; w < by_variation.size(); ++w) {
    const bool held = (now_.variation[w] >= tolerance_[w] && by_variation[w] < 0) ||
                      (now_.variation[w] <= -tolerance_[w] && by_variation[w] > 0);
    if (!held) free.push_back(w);
  }
  const Eigen::MatrixXd lengths = elastic_lengths_(Eigen::all, free);
  Eigen::LLT<Eigen::MatrixXd> by_free;
  const auto m = static_cast<Eigen::Index>(free.size());
  if (m > 0) {
    Eigen::MatrixXd s = system_.hessian_by_variation()(free, free);
    s.diagonal() *= 1 + 1e-9;
    by_free.compute(s);
    if (by_free.info() != Eigen::Success) return false;
  }
  const auto precondition = [&](Eigen::VectorXd& r) -> Eigen::VectorXd {
    const Positions2 force = Eigen::Map<const Positions2>(r.data(), n / 2, 2);
    Eigen::VectorXd lambda, z(n + m);
    Positions2 x;
    system_.solve(force, none, x, lambda);
    if (m > 0) {
      z.tail(m) = by_free.solve(r.tail(m) + lengths.transpose() * lambda);
      system_.solve(force, lengths * z.tail(m), x, lambda);
    }
    z.head(n) = Eigen::Map<const Eigen::VectorXd>(x.data(), n);
    Positions2 normal = Positions2::Zero(n / 2, 2);
    constraints_.add_transposed(system_.directions(), lambda, normal);
    r.head(n) -= Eigen::Map<const Eigen::VectorXd>(normal.data(), n);
    r.tail(m) += lengths.transpose() * lambda;
    return z;
  };
  const auto times_hessian = [&](const Eigen::VectorXd& x) -> Eigen::VectorXd {
    Eigen::VectorXd y = Eigen::VectorXd::Zero(n + m);
    y.head(n) = hessian.selfadjointView<Eigen::Lower>() * x.head(n);
    return y;
  };
  Eigen::VectorXd g = Eigen::VectorXd::Zero(n + m);
  g.head(n) = Eigen::Map<const Eigen::VectorXd>(gradient.data(), n);
  const TangentModel model(times_hessian, precondition, g, (int)env("DIM", 15));
  if (radius_ == 0) radius_ = env("R0", 1) * model.convex_length();
  if (verbose()) printf("trust: f %.8g decrement %.3g flips %d dim %d lowest %.3g", now_.value, model.convex_length() * model.convex_length() / now_.value, objective_.count_flips(now_.uv), model.size(), model.lowest());

  bool found = false;
  RefinedSolution best;
  double best_radius = 0;
  bool inside = false;
  for (int i = 0; i < 30; ++i) {
    const ModelStep step = model.step(radius_);
    Positions2 uv = now_.uv + Eigen::Map<const Positions2>(step.d.data(), n / 2, 2);
    Eigen::VectorXd variation = now_.variation;
    for (Eigen::Index k = 0; k < m; ++k) variation[free[at(static_cast<int>(k))]] += step.d[n + k];
    variation = variation.cwiseMax(-tolerance_).cwiseMin(tolerance_);
    const bool restored = restore(uv, variation);
    const double value = restored ? objective_.value(uv) : 0;
    const double ratio = restored ? (now_.value - value) / step.decrease : -1;
    if (verbose()) printf(" (%.2g: %.2g)", step.length, ratio);
    if (ratio > 0.1 && (!found || value < best.value)) {
      found = true;
      best.uv = std::move(uv);
      best.variation = variation;
      best.value = value;
      best_radius = radius_;
      inside = step.is_inside;
      if (ratio < env("GROW", 0.5) || step.is_inside) break;
      radius_ = 2 * radius_;
    } else {
      if (found) break;
      radius_ = std::min(radius_, step.length) / env("SHRINK", 3);
    }
  }
  if (found) radius_ = best_radius;
  if (verbose()) printf("%s\n", inside ? " inside" : "");
  if (!found) return false;
  now_.uv = std::move(best.uv);
  now_.variation = best.variation;
  now_.value = best.value;
  is_positive_ = inside;
  return true;
}

void Refinement::minimize() {
  is_positive_ = true;
  Positions2 gradient;
  while (may_go_on()) {
    now_.value = objective_.value_and_gradient(now_.uv, gradient);
    ++now_.iterations;
    bool accepted = false;
    if (is_positive_) is_positive_ = take_newton_step(gradient, accepted);
    if (now_.converged) return;
    if (accepted) continue;
    is_positive_ = false;
    if (!may_go_on() || !take_trust_region_step(gradient)) return;
  }
}

RefinedSolution Refinement::run(const Positions2& start, int max_factorizations, const std::function<bool()>& go_on) {
  max_factorizations_ = max_factorizations;
  go_on_ = go_on;
  now_.uv = start;
  now_.variation = Eigen::VectorXd::Zero(constraints_.num_elastic());
  multipliers_ = Eigen::VectorXd::Zero(constraints_.size());
  if (constraints_.num_elastic() > 0) {
    Eigen::VectorXd length = Eigen::VectorXd::Zero(constraints_.num_elastic());
    for (const LengthConstraints::Edge& edge : constraints_.edges()) {
      if (edge.elastic >= 0) length[edge.elastic] += (start.row(edge.b) - start.row(edge.a)).norm();
    }
    const Eigen::VectorXd rest = elastic_lengths_.colwise().sum().transpose();
    now_.variation = (length.cwiseQuotient(rest).array() - 1).matrix().cwiseMax(-tolerance_).cwiseMin(tolerance_);
  }
  now_.is_exact = reach_exact_lengths();
  if (now_.is_exact) minimize();
  if (verbose()) printf("\n");
  now_.length_error = constraints_.largest_error(constraints_.residual(now_.uv, now_.variation));
  now_.value = objective_.value(now_.uv);
  now_.factorizations = system_.num_factorizations();
  now_.solves = system_.num_solves();
  return now_;
}

}  // namespace

RefinedSolution refine_shape(const Chart& chart, const WireNetwork& network, double fairness, int max_factorizations,
                             const Positions2& start, const std::function<bool()>& go_on) {
  return Refinement(chart, network, fairness).run(start, max_factorizations, go_on);
}

}  // namespace wirewarp
