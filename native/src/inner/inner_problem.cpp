// SPDX-License-Identifier: GPL-3.0-or-later
#include "inner/inner_problem.h"

namespace wirewarp {
namespace {

constexpr double kClosed = 1e-12;       // a loop closes: gap / length of the loop
constexpr double kNearlyClosed = 1e-3;  // the factor at hand is good enough to close the rest
constexpr double kRounding = 2e-15;     // no better can be had in double precision
constexpr double kStationary = 1e-10;   // projected gradient
constexpr int kMaxSteps = 100;
constexpr double kSmallestStep = 1e-6;

double largest(const Eigen::VectorXd& v) { return v.size() == 0 ? 0 : v.lpNorm<Eigen::Infinity>(); }

}  // namespace

InnerSolution InnerProblem::solve(const Eigen::VectorXd& lengths, Inner inner) {
  const int solves_before = kkt_.num_factorizations();
  InnerSolution solution;
  solution.is_feasible = close_loops(lengths, solution.psi);
  if (solution.is_feasible) solution.is_minimum = inner == Inner::least_norm || minimize(lengths, solution);
  solution.headings = eq1_.headings(solution.psi);
  solution.angle_variation = eq1_.angle_variation(solution.psi);
  solution.closure_residual = largest(eq1_.closure(solution.psi, lengths));
  solution.num_solves = kkt_.num_factorizations() - solves_before;
  return solution;
}

/// The minimum satisfies ∇F + Jᵀλ = 0 and c = 0. Differentiated by a length: K [dψ; dλ] = -[∂(Jᵀλ)/∂l; ∂c/∂l] dl, with
/// K the matrix of the optimality system. Adjoint: K [p; q] = [∂E/∂φ; 0], and dE/dl = ∂E/∂l - pᵀ∂(Jᵀλ)/∂l - qᵀ∂c/∂l.
Eigen::VectorXd InnerProblem::total_derivative(const InnerSolution& solution, const Eigen::VectorXd& lengths,
                                               const Eigen::VectorXd& by_headings, const Eigen::VectorXd& by_lengths) {
  kkt_.factor(eq1_.laplacian(), eq1_.closure_hessian(solution.psi, lengths, solution.multipliers),
              eq1_.closure_jacobian(solution.psi, lengths));
  const KktSystem::Solution adjoint = kkt_.solve(by_headings, Eigen::VectorXd::Zero(eq1_.num_closures()));
  return by_lengths -
         adjoint.step.cwiseProduct(eq1_.closure_by_headings_and_lengths(solution.psi, solution.multipliers)) -
         eq1_.closure_by_lengths(solution.psi, adjoint.multipliers);
}

/// The paper's least-norm steps, from the angles closest to the surface angles. Where they stray, once more from the
/// headings that follow the surface angles, which no symmetry holds fast: a wire that is straight by symmetry can only
/// be shortened by breaking it.
bool InnerProblem::close_loops(const Eigen::VectorXd& lengths, Eigen::VectorXd& psi) {
  psi = Eigen::VectorXd::Zero(eq1_.num_edges());
  if (take_least_norm_steps(lengths, 1, psi)) return true;
  psi = eq1_.surface_start();
  kkt_.factor(eq1_.laplacian(), Eigen::VectorXd::Zero(eq1_.num_edges()), eq1_.closure_jacobian(psi, lengths));
  psi += kkt_.solve(-eq1_.gradient(psi), -eq1_.closure(psi, lengths)).step;
  return take_least_norm_steps(lengths, kSmallestStep, psi);
}

/// Steps by the smallest weighted change of the current angles that closes the linearized loops, shortened, but not
/// below smallest_step, where the gap would not shrink. False if the loops stay open.
bool InnerProblem::take_least_norm_steps(const Eigen::VectorXd& lengths, double smallest_step, Eigen::VectorXd& psi) {
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(eq1_.num_edges());
  Eigen::VectorXd gap = eq1_.closure(psi, lengths);
  for (int i = 0; i < kMaxSteps && largest(gap) > kRounding; ++i) {
    kkt_.factor(eq1_.laplacian(), zero, eq1_.closure_jacobian(psi, lengths));
    const Eigen::VectorXd step = kkt_.solve(zero, -gap).step;
    double t = 1;
    Eigen::VectorXd trial_gap = eq1_.closure(psi + step, lengths);
    while (!(trial_gap.norm() < (1 - 1e-3 * t) * gap.norm()) && t >= smallest_step) {
      t /= 2;
      trial_gap = eq1_.closure(psi + t * step, lengths);
    }
    if (t < smallest_step) break;
    psi += t * step;
    gap = trial_gap;
    if (largest(gap) < kNearlyClosed && restore(lengths, psi)) return true;
    gap = eq1_.closure(psi, lengths);
  }
  return largest(gap) < kClosed;
}

/// Closes the loops again after a step along them, with the factor at hand.
bool InnerProblem::restore(const Eigen::VectorXd& lengths, Eigen::VectorXd& psi) const {
  constexpr int kMaxRestorations = 40;  // each a back-substitution: cheaper than shorter steps and new factors
  constexpr double kWorthwhile = 0.8;
  const Eigen::VectorXd no_gradient = Eigen::VectorXd::Zero(eq1_.num_edges());
  Eigen::VectorXd gap = eq1_.closure(psi, lengths);
  for (int i = 0; i < kMaxRestorations && largest(gap) > kRounding; ++i) {
    const Eigen::VectorXd trial = psi + kkt_.solve(no_gradient, -gap).step;
    const Eigen::VectorXd trial_gap = eq1_.closure(trial, lengths);
    if (!(trial_gap.norm() < kWorthwhile * gap.norm())) break;
    psi = trial;
    gap = trial_gap;
  }
  return largest(gap) < kClosed;
}

/// Factors with as much of the closures' curvature as leaves the step leading downhill; none always does. share: what
/// to try after all of it; comes back closer to all where it served, so that a saddle is left behind fast.
void InnerProblem::factor_downhill(const Eigen::VectorXd& closure_hessian, const Eigen::SparseMatrix<double>& jacobian,
                                   double& share) {
  if (kkt_.factor(eq1_.laplacian(), closure_hessian, jacobian)) return;
  if (kkt_.factor(eq1_.laplacian(), share * closure_hessian, jacobian)) {
    share = (1 + share) / 2;
    return;
  }
  share /= 2;
  if (kkt_.factor(eq1_.laplacian(), share * closure_hessian, jacobian)) return;
  kkt_.factor(eq1_.laplacian(), 0 * closure_hessian, jacobian);
}

/// Feasible sequential quadratic programming with the exact Hessian of the Lagrangian: every iterate closes.
bool InnerProblem::minimize(const Eigen::VectorXd& lengths, InnerSolution& solution) {
  Eigen::VectorXd& psi = solution.psi;
  Eigen::VectorXd& multipliers = solution.multipliers;
  const Eigen::VectorXd no_gap = Eigen::VectorXd::Zero(eq1_.num_closures());
  double curvature_share = 0.5;
  double value = eq1_.angle_variation(psi);
  for (int i = 0; i < kMaxSteps; ++i) {
    const Eigen::VectorXd gradient = eq1_.gradient(psi);
    const Eigen::SparseMatrix<double> jacobian = eq1_.closure_jacobian(psi, lengths);
    if (i == 0) {
      if (kkt_.num_factorizations() == 0)
        kkt_.factor(eq1_.laplacian(), Eigen::VectorXd::Zero(eq1_.num_edges()), jacobian);
      multipliers = kkt_.solve(-gradient, no_gap).multipliers;
    }
    solution.projected_gradient = largest(gradient + jacobian.transpose() * multipliers);
    if (solution.projected_gradient < kStationary) return true;

    factor_downhill(eq1_.closure_hessian(psi, lengths, multipliers), jacobian, curvature_share);
    const KktSystem::Solution direction = kkt_.solve(-gradient, no_gap);
    const double slope = gradient.dot(direction.step);
    double t = 1;
    for (; t > kSmallestStep; t /= 2) {
      Eigen::VectorXd trial = psi + t * direction.step;
      if (!restore(lengths, trial)) continue;
      const double trial_value = eq1_.angle_variation(trial);
      if (trial_value > value + 1e-4 * t * slope + 1e-14 * value) continue;
      psi = trial;
      value = trial_value;
      break;
    }
    if (t <= kSmallestStep) return false;
    multipliers = direction.multipliers;
  }
  return false;
}

}  // namespace wirewarp
