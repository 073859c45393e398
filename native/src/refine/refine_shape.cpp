// SPDX-License-Identifier: GPL-3.0-or-later
#include "refine/refine_shape.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "mesh/geometry.h"
#include "network/length_variation.h"
#include "optimize/box_quadratic.h"
#include "refine/lanczos_trust_region.h"
#include "refine/retract_to_lengths.h"
#include "refine/tangent_space.h"

namespace wirewarp {
namespace {

constexpr double kWorthwhile = 1e-9;  // decrease that a step must promise, over f
constexpr double kIsometric = 1e-22;  // the same over the area: strains of 1e-11
constexpr double kSufficient = 1e-4;  // share of the promised decrease that a Newton step must bring
constexpr double kAcceptRatio = 0.1;  // the same for a step in a ball
constexpr double kGrowRatio = 0.5;    // from here on a larger ball is tried
constexpr double kShrink = 3;         // of the ball, after a bad step
constexpr int kMaxRadii = 30;         // 3³⁰: no step, however short, goes down
constexpr int kMaxKrylovSize = 15;
constexpr double kNear = 1e-2;      // slope of a Newton step over f, so small that the factor stays good
constexpr double kMuchLess = 1e-2;  // slope of a step with the same factor, over that of the one before
constexpr double kFlat = 1e-4;      // negative curvature over that of the convex part which is not worth a step
constexpr int kPatience = 30;       // factorizations after which triangles turned over are not expected to open

constexpr Convexity kExactHessian{Curvature::exact, true};
constexpr Convexity kConvexHessian{Curvature::convex, false};
constexpr Convexity kLaplacian{Curvature::none, false};

/// The longer side of the box around a layout.
double extent(const Positions2& uv) { return (uv.colwise().maxCoeff() - uv.colwise().minCoeff()).maxCoeff(); }

double dot(const Positions2& a, const Positions2& b) { return (a.array() * b.array()).sum(); }

struct Iterate {
  Positions2 uv;
  Eigen::VectorXd variation;  // h of the elastic parts
  double value = 0;           // f
};

/// ε of the elastic parts.
Eigen::VectorXd tolerances(const Chart& chart, const LengthConstraints& constraints) {
  Eigen::VectorXd tolerance(constraints.num_elastic());
  for (int w = 0; w < tolerance.size(); ++w) {
    tolerance[w] = chart.wire_parts[constraints.elastic_parts()[w]].tolerance;
  }
  return tolerance;
}

/// h of the elastic parts within their tolerances.
Eigen::VectorXd nearest_variation(const Chart& chart, const LengthConstraints& constraints,
                                  const Eigen::VectorXd& tolerance, const Positions2& uv) {
  return length_variation(chart, uv)(constraints.elastic_parts()).cwiseMax(-tolerance).cwiseMin(tolerance);
}

/// f, below which a layout is isometric but for rounding: that is felt on slivers and edges of 1e-8 of the piece.
double isometric_value(const Chart& chart, const FairShapeError& objective, const Positions2& uv) {
  const double rounding = objective.value_of_rounding(std::numeric_limits<double>::epsilon() * extent(uv));
  return std::max(kIsometric * surface_area(chart.mesh), rounding);
}

/// Without multipliers and how it was reached.
RefinedShape describe(const Chart& chart, const LengthConstraints& constraints, const Iterate& iterate) {
  RefinedShape shape;
  shape.uv = iterate.uv;
  shape.variation = length_variation(chart, iterate.uv);
  for (int i = 0; i < shape.variation.size(); ++i) {
    if (chart.wire_parts[i].kind != WireKind::super_elastic) shape.variation[i] = 0;
  }
  shape.variation(constraints.elastic_parts()) = iterate.variation;
  shape.objective = iterate.value / surface_area(chart.mesh);
  shape.length_error = constraints.largest_error(constraints.residual(iterate.uv, iterate.variation));
  return shape;
}

class Refinement {
 public:
  Refinement(const Chart& chart, const WireNetwork& network, double fairness, const RefinementStart& start,
             const RefinementLimits& limits);

  bool reach_exact_lengths();
  void minimize();
  RefinedShape shape(const Chart& chart) const;

 private:
  struct Step {
    Positions2 d;
    Eigen::VectorXd variation;    // Δh
    Eigen::VectorXd multipliers;  // λ
    double slope;                 // of f along the step
  };
  enum class Outcome { accepted, rejected, not_positive, converged };

  bool factorize_at_start();
  bool stays_flipped() const {
    return system_.num_factorizations() >= kPatience && objective_.count_flips(now_.uv) > 0;
  }
  bool may_go_on() const { return limits_.budget.allows() && limits_.stop.may_go_on(); }
  double worthwhile() const { return std::max(kWorthwhile * now_.value, isometric_); }
  double length_error() const { return constraints_.largest_error(constraints_.residual(now_.uv, now_.variation)); }
  bool factorize(const Convexity& convexity);
  Step newton_step() const;
  bool evaluate(Iterate& trial) const;
  Outcome take_step();
  Outcome take_newton_step();
  Outcome take_steps_with_factor(double slope);
  Outcome trust_region_step();
  Outcome search_trust_region(const TangentSpace& space, const std::function<ModelStep(double radius)>& step_in);
  std::vector<int> free_parts() const;

  LengthConstraints constraints_;
  FairShapeError objective_;
  NewtonSystem system_;
  RefinementLimits limits_;
  double isometric_;  // f
  bool starts_near_minimum_;
  Eigen::VectorXd tolerance_;  // ε of the elastic parts

  Iterate now_;
  Positions2 gradient_;           // of f
  Eigen::VectorXd multipliers_;   // λ
  Eigen::MatrixXd by_variation_;  // ∂λ/∂h for the factor
  double radius_ = 0;             // of the ball; 0: not chosen yet
  bool is_positive_ = true;       // the exact Hessian is expected to be
  bool is_exact_ = false;
  bool converged_ = false;
  int iterations_ = 0;
};

Refinement::Refinement(const Chart& chart, const WireNetwork& network, double fairness, const RefinementStart& start,
                       const RefinementLimits& limits)
    : constraints_(chart, network),
      objective_(chart, network, fairness, limits.injectivity, start.uv),
      system_(chart, objective_, constraints_, start.uv),
      limits_(limits),
      isometric_(isometric_value(chart, objective_, start.uv)),
      starts_near_minimum_(start.multipliers.size() > 0),
      tolerance_(tolerances(chart, constraints_)) {
  now_.uv = start.uv;
  now_.variation = nearest_variation(chart, constraints_, tolerance_, start.uv);
  multipliers_ = starts_near_minimum_ ? start.multipliers : Eigen::VectorXd::Zero(constraints_.size());
}

bool Refinement::factorize(const Convexity& convexity) {
  limits_.budget.spend(1);
  if (!system_.factorize(now_.uv, multipliers_, convexity)) return false;
  if (constraints_.num_elastic() > 0) by_variation_ = system_.multipliers_by_variation();
  return true;
}

/// The quadratic program min g·d + ½ d·H d, J d - T Δh = -c, h + Δh in its bounds. With d eliminated a dense one in Δh
/// is left, with the Hessian S and the gradient -Tᵀλ. It is solved for the change of λ, g + Jᵀλ in place of g: so a
/// factor from before the last step, with the J of then, is wrong in what is small.
Refinement::Step Refinement::newton_step() const {
  const Eigen::VectorXd residual = constraints_.residual(now_.uv, now_.variation);
  Positions2 force = gradient_;
  constraints_.add_transposed(constraints_.directions(now_.uv), multipliers_, force);
  NewtonSystem::Solution solution = system_.solve_on_wires(-force, -residual);
  const Eigen::SparseMatrix<double>& lengths = constraints_.elastic_lengths();
  Eigen::VectorXd variation = Eigen::VectorXd::Zero(constraints_.num_elastic());
  if (constraints_.num_elastic() > 0) {
    variation = minimize_quadratic_in_box(-(lengths.transpose() * (multipliers_ + solution.multipliers.col(0))),
                                          make_positive(hessian_by_variation(lengths, by_variation_)),
                                          -tolerance_ - now_.variation, tolerance_ - now_.variation);
    solution.multipliers += by_variation_ * variation;
    system_.solve_on_wires(lengths * variation - residual, solution);
  }
  Step step{system_.finish(solution.d), std::move(variation), multipliers_ + solution.multipliers.col(0), 0};
  step.slope = dot(force, step.d) - multipliers_.dot(lengths * step.variation - residual);
  return step;
}

/// Takes the trial to exact lengths; false where that fails, or something forbidden lies on the way.
bool Refinement::evaluate(Iterate& trial) const {
  trial.variation = trial.variation.cwiseMax(-tolerance_).cwiseMin(tolerance_);
  if (!retract_to_lengths(constraints_, system_, trial.variation, trial.uv)) return false;
  if (objective_.longest_step(now_.uv, trial.uv - now_.uv) < 1) return false;
  trial.value = objective_.value(trial.uv);
  return true;
}

/// Near the minimum the exact Hessian, or its convex part where it is not positive; else the Laplacian.
bool Refinement::factorize_at_start() {
  const auto try_to_factorize = [&](const Convexity& convexity) {
    limits_.stop.check();
    return limits_.budget.allows() && factorize(convexity);
  };
  if (!starts_near_minimum_) return try_to_factorize(kLaplacian);
  return try_to_factorize(kExactHessian) || try_to_factorize(kConvexHessian);
}

/// One Newton step and the way back from its end; near the minimum a second one where that is too long.
bool Refinement::reach_exact_lengths() {
  now_.value = objective_.value_and_gradient(now_.uv, gradient_);
  is_exact_ = length_error() <= LengthConstraints::kept;
  for (int i = 0; i < (starts_near_minimum_ ? 2 : 1) && !is_exact_ && factorize_at_start(); ++i) {
    Step step = newton_step();
    Iterate trial{now_.uv + step.d, now_.variation + step.variation};
    multipliers_ = std::move(step.multipliers);
    ++iterations_;
    is_exact_ = evaluate(trial);
    if (!is_exact_) trial.value = objective_.value_and_gradient(trial.uv, gradient_);
    now_ = std::move(trial);
  }
  return is_exact_;
}

Refinement::Outcome Refinement::take_newton_step() {
  if (!factorize(kExactHessian)) return Outcome::not_positive;
  const Step step = newton_step();
  const bool is_last = std::abs(step.slope) < worthwhile();
  for (const double t : {1.0, 0.5}) {  // shorter steps are better taken in a trust region
    Iterate trial{now_.uv + t * step.d, now_.variation + t * step.variation};
    if (!evaluate(trial) || !(trial.value <= now_.value + kSufficient * t * step.slope)) continue;
    now_ = std::move(trial);
    multipliers_ += t * (step.multipliers - multipliers_);
    if (is_last) return Outcome::converged;
    const bool is_near = t == 1 && std::abs(step.slope) < kNear * now_.value;
    return is_near ? take_steps_with_factor(step.slope) : Outcome::accepted;
  }
  return is_last ? Outcome::converged : Outcome::rejected;
}

/// Newton steps with the factor from before a step with the given slope, as long as each leaves little to the next.
Refinement::Outcome Refinement::take_steps_with_factor(double slope) {
  while (limits_.stop.may_go_on()) {
    now_.value = objective_.value_and_gradient(now_.uv, gradient_);
    Step step = newton_step();
    if (std::abs(step.slope) > kMuchLess * std::abs(slope)) break;
    const bool is_last = std::abs(step.slope) < worthwhile();
    Iterate trial{now_.uv + step.d, now_.variation + step.variation};
    const bool is_better = evaluate(trial) && trial.value <= now_.value + kSufficient * step.slope;
    if (is_better) {
      ++iterations_;
      now_ = std::move(trial);
      multipliers_ = std::move(step.multipliers);
    }
    if (is_last) return Outcome::converged;
    if (!is_better) break;
    slope = step.slope;
  }
  return Outcome::accepted;
}

/// All elastic parts but those at a bound that would go beyond it: f falls by (Tᵀλ)_w per unit of h_w.
std::vector<int> Refinement::free_parts() const {
  const Eigen::VectorXd pull = constraints_.elastic_lengths().transpose() * multipliers_;
  std::vector<int> free;
  for (int w = 0; w < constraints_.num_elastic(); ++w) {
    const bool is_held = pull[w] > 0 ? now_.variation[w] >= tolerance_[w] : now_.variation[w] <= -tolerance_[w];
    if (!is_held) free.push_back(w);
  }
  return free;
}

Refinement::Outcome Refinement::trust_region_step() {
  limits_.budget.spend(1);
  if (!system_.factorize(now_.uv, multipliers_, kConvexHessian)) return Outcome::not_positive;
  multipliers_ = system_.solve_on_wires(-gradient_, Eigen::VectorXd::Zero(constraints_.size())).multipliers;
  const TangentSpace space(system_, constraints_, free_parts());
  const Eigen::SparseMatrix<double> hessian = system_.hessian(now_.uv, multipliers_, kExactHessian);
  const auto times_hessian = [&](const Eigen::VectorXd& x) -> Eigen::VectorXd {
    Eigen::VectorXd y = Eigen::VectorXd::Zero(x.size());
    y.head(hessian.rows()) = hessian.selfadjointView<Eigen::Lower>() * x.head(hessian.rows());
    return y;
  };
  const auto precondition = [&](Eigen::VectorXd& force) { return space.solve(force); };
  const auto model_for = [&](const Positions2& gradient) {
    return LanczosTrustRegion(times_hessian, precondition, space.force_on_vertices(gradient), kMaxKrylovSize);
  };
  const LanczosTrustRegion model = model_for(gradient_);
  if (radius_ == 0) radius_ = model.convex_length();
  const bool is_stationary = model.convex_length() * model.convex_length() < worthwhile();
  if (!is_stationary) return search_trust_region(space, [&](double radius) { return model.step(radius); });

  // A saddle. Its way down may be against a symmetry that the gradient has: look for it where a mirror image would
  // push, a quarter turn from the forces in the wires.
  Positions2 tension = Positions2::Zero(now_.uv.rows(), 2);
  constraints_.add_transposed(system_.directions(), multipliers_, tension);
  Positions2 turned(tension.rows(), 2);
  turned.col(0) = -tension.col(1);
  turned.col(1) = tension.col(0);
  const LanczosTrustRegion off_saddle = model_for(turned);
  if (off_saddle.lowest_curvature() > -kFlat) return Outcome::converged;
  return search_trust_region(space, [&](double radius) { return off_saddle.step_along_lowest_curvature(radius); });
}

/// The largest ball whose step goes down as the model says.
Refinement::Outcome Refinement::search_trust_region(const TangentSpace& space,
                                                    const std::function<ModelStep(double radius)>& step_in) {
  bool found = false;
  Iterate best;
  double best_radius = 0;
  for (int i = 0; i < kMaxRadii; ++i) {
    const ModelStep step = step_in(radius_);
    Iterate trial = now_;
    trial.uv += Eigen::Map<const Positions2>(step.d.data(), now_.uv.rows(), 2);
    trial.variation(space.free()) += step.d.tail(static_cast<Eigen::Index>(space.free().size()));
    const double share = evaluate(trial) ? (now_.value - trial.value) / step.decrease : -1;
    if (share > kAcceptRatio && (!found || trial.value < best.value)) {
      found = true;
      best = std::move(trial);
      best_radius = radius_;
      is_positive_ = step.is_inside;
      if (share < kGrowRatio || step.is_inside) break;
      radius_ *= 2;
    } else if (found) {
      break;
    } else {
      radius_ = std::min(radius_, step.length) / kShrink;
    }
  }
  if (!found) return Outcome::rejected;
  radius_ = best_radius;
  now_ = std::move(best);
  return Outcome::accepted;
}

/// A Newton step where the exact Hessian is positive, a step in a ball where it is not or that fails.
Refinement::Outcome Refinement::take_step() {
  Outcome outcome = is_positive_ ? take_newton_step() : Outcome::not_positive;
  is_positive_ = outcome == Outcome::accepted;
  const bool failed = outcome == Outcome::not_positive || outcome == Outcome::rejected;
  if (failed && may_go_on()) outcome = trust_region_step();
  return outcome;
}

void Refinement::minimize() {
  const auto is_isometric = [&] { return now_.value <= isometric_; };  // no step takes off more than all
  Outcome outcome = Outcome::accepted;
  while (outcome == Outcome::accepted && !is_isometric() && !stays_flipped() && may_go_on()) {
    now_.value = objective_.value_and_gradient(now_.uv, gradient_);
    ++iterations_;
    outcome = take_step();
  }
  converged_ = outcome == Outcome::converged || is_isometric();
}

RefinedShape Refinement::shape(const Chart& chart) const {
  RefinedShape shape = describe(chart, constraints_, now_);
  shape.multipliers = multipliers_;
  shape.iterations = iterations_;
  shape.factorizations = system_.num_factorizations();
  shape.is_exact = is_exact_;
  shape.converged = converged_;
  return shape;
}

}  // namespace

RefinedShape refine_shape(const Chart& chart, const WireNetwork& network, double fairness, const RefinementStart& start,
                          const RefinementLimits& limits) {
  Refinement refinement(chart, network, fairness, start, limits);
  if (refinement.reach_exact_lengths()) refinement.minimize();
  return refinement.shape(chart);
}

RefinedShape evaluate_shape(const Chart& chart, const WireNetwork& network, double fairness,
                            const RefinementStart& start) {
  const LengthConstraints constraints(chart, network);
  const FairShapeError objective(chart, network, fairness);
  const Eigen::VectorXd tolerance = tolerances(chart, constraints);
  const Iterate at_start{start.uv, nearest_variation(chart, constraints, tolerance, start.uv),
                         objective.value(start.uv)};
  RefinedShape shape = describe(chart, constraints, at_start);
  shape.multipliers =
      start.multipliers.size() > 0 ? start.multipliers : Eigen::VectorXd(Eigen::VectorXd::Zero(constraints.size()));
  shape.is_exact = shape.length_error <= LengthConstraints::kept;
  shape.converged = at_start.value <= isometric_value(chart, objective, start.uv);
  return shape;
}

}  // namespace wirewarp
