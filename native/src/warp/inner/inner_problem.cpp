// SPDX-License-Identifier: GPL-3.0-or-later
#include "warp/inner/inner_problem.h"

#include <algorithm>

#include "numerics/optimize/line_search.h"

namespace wirewarp {
namespace {

constexpr double kClosed = 1e-12;       // largest gap/length of a loop that counts as closed; the guarantee is 1e-9
constexpr double kNearlyClosed = 1e-3;  // largest gap that restore() can close with the present factor
constexpr double kRounding = 2e-15;     // smallest gap that double precision allows
constexpr double kStationary = 1e-10;   // largest projected gradient at a minimum; gives E six correct digits
constexpr int kMaxSteps = 100;          // 3 to 16 are usual
constexpr double kSmallestStep = 1e-6;  // a full step is halved at most twenty times
constexpr double kBend = 0.3;  // radians at the edge that turns most; after such a step, the loops can still be closed
constexpr double kLongestTurn = 2;  // radians between two edges; for larger turns the gap is not linear in the headings
constexpr double kStalledRatio = 0.4;  // a full step that leaves a larger share of the gap is blocked by symmetry

double largest(const Eigen::VectorXd& v) { return v.size() == 0 ? 0 : v.lpNorm<Eigen::Infinity>(); }

}  // namespace

InnerSolution InnerProblem::solve(const Eigen::VectorXd& lengths, Inner inner) {
  return solve_from(Eigen::VectorXd::Zero(eq1_.num_edges()), lengths, inner);
}

InnerSolution InnerProblem::follow(const InnerSolution& from, const Eigen::VectorXd& lengths) {
  return solve_from(from.psi, lengths, Inner::minimum);
}

InnerSolution InnerProblem::solve_from(const Eigen::VectorXd& start, const Eigen::VectorXd& lengths, Inner inner) {
  const int solves_before = kkt_.num_factorizations();
  InnerSolution solution;
  solution.psi = start;
  solution.is_feasible = close_loops(lengths, solution.psi);
  if (solution.is_feasible) solution.is_minimum = inner == Inner::least_norm || minimize(lengths, solution);
  solution.headings = eq1_.headings(solution.psi);
  solution.closure_residual = largest(eq1_.closure(solution.psi, lengths));
  solution.num_solves = kkt_.num_factorizations() - solves_before;
  return solution;
}

void InnerProblem::linearize(const InnerSolution& solution, const Eigen::VectorXd& lengths) {
  kkt_.factor(eq1_.laplacian(), eq1_.closure_hessian(solution.psi, lengths, solution.multipliers),
              eq1_.closure_jacobian(solution.psi, lengths));
}

/// Solves K [dψ; dλ] = -[∂(Jᵀλ)/∂l; ∂c/∂l] dl, the derivative of the optimality system ∇F + Jᵀλ = 0, c = 0. K is the
/// matrix that linearize() has factored.
/// c is linear in l, so ∂c/∂l dl is c for the lengths dl.
Eigen::VectorXd InnerProblem::change_of_headings(const InnerSolution& solution,
                                                 const Eigen::VectorXd& change_of_lengths) const {
  const Eigen::VectorXd by_lengths = eq1_.closure_by_headings_and_lengths(solution.psi, solution.multipliers);
  return kkt_.solve(-by_lengths.cwiseProduct(change_of_lengths), -eq1_.closure(solution.psi, change_of_lengths)).step;
}

/// Solves the adjoint system K [p; q] = [∂E/∂φ; 0]; then dE/dl = ∂E/∂l - pᵀ∂(Jᵀλ)/∂l - qᵀ∂c/∂l.
Eigen::VectorXd InnerProblem::total_derivative(const InnerSolution& solution, const Eigen::VectorXd& by_headings,
                                               const Eigen::VectorXd& by_lengths) const {
  const KktSystem::Solution adjoint = kkt_.solve(by_headings, Eigen::VectorXd::Zero(eq1_.num_closures()));
  return by_lengths -
         adjoint.step.cwiseProduct(eq1_.closure_by_headings_and_lengths(solution.psi, solution.multipliers)) -
         eq1_.closure_by_lengths(solution.psi, adjoint.multipliers);
}

/// Closes the loops by the paper's least-norm steps, and returns whether they are closed. Afterwards, kkt_ contains the
/// factor of the last step, or of the start if no loop was open.
bool InnerProblem::close_loops(const Eigen::VectorXd& lengths, Eigen::VectorXd& psi) {
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(eq1_.num_edges());
  Eigen::VectorXd gap = eq1_.closure(psi, lengths);
  bool has_bent = false;
  for (int i = 0; i < kMaxSteps; ++i) {
    const Eigen::SparseMatrix<double> jacobian = eq1_.closure_jacobian(psi, lengths);
    kkt_.factor(eq1_.laplacian(), zero, jacobian);
    if (largest(gap) <= kRounding) return true;
    const KktSystem::Solution closing = kkt_.solve(zero, -gap);
    const auto share_left = [&](double t) { return eq1_.closure(psi + t * closing.step, lengths).norm() / gap.norm(); };
    const double longest = std::min(1.0, kLongestTurn / (closing.step.maxCoeff() - closing.step.minCoeff()));
    double t = longest;
    while (!(share_left(t) < 1 - 1e-3 * t) && t > kSmallestStep) t /= 2;
    const bool is_held = t < longest || (t == 1 && share_left(t) > kStalledRatio);
    if (is_held && !has_bent) {
      // A wire must bend to fit between its ends, but symmetry keeps it straight: the linearized constraints have no
      // step that bends it.
      double share = 0.5;
      factor_downhill(eq1_.closure_hessian(psi, lengths, closing.multipliers), jacobian, share);
      psi += kBend * inverse_iteration(eq1_.symmetry_breaker());
      gap = eq1_.closure(psi, lengths);
      has_bent = true;
      continue;
    }
    if (t <= kSmallestStep) break;
    psi += t * closing.step;
    gap = eq1_.closure(psi, lengths);
    if (largest(gap) < kNearlyClosed) {
      if (restore(lengths, psi)) return true;
      gap = eq1_.closure(psi, lengths);
    }
  }
  return largest(gap) < kClosed;
}

/// Closes the loops after a tangential step, with the present factor. Returns whether all loops are closed.
bool InnerProblem::restore(const Eigen::VectorXd& lengths, Eigen::VectorXd& psi) const {
  constexpr int kMaxRestorations = 40;  // each takes one solve, which is faster than a new factor
  constexpr double kWorthwhile = 0.8;   // largest share of the gap that a step may leave; slower steps have stalled
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

/// Factors the system with a share of the closures' curvature for which the step goes downhill. Tries the shares 1,
/// `share`, half of `share`, and 0. Returns whether the share 1 was used; otherwise adapts `share` for the next call.
bool InnerProblem::factor_downhill(const Eigen::VectorXd& closure_hessian, const Eigen::SparseMatrix<double>& jacobian,
                                   double& share) {
  if (kkt_.factor(eq1_.laplacian(), closure_hessian, jacobian)) return true;
  if (kkt_.factor(eq1_.laplacian(), share * closure_hessian, jacobian)) {
    share = (1 + share) / 2;
    return false;
  }
  share /= 2;
  if (!kkt_.factor(eq1_.laplacian(), share * closure_hessian, jacobian)) {
    kkt_.factor(eq1_.laplacian(), 0 * closure_hessian, jacobian);
  }
  return false;
}

/// Returns a change of headings near the eigenvector of the smallest eigenvalue, with largest entry 1, that keeps the
/// loops closed. turn: start of the iteration, which must not depend on the numbering.
Eigen::VectorXd InnerProblem::inverse_iteration(Eigen::VectorXd turn) const {
  constexpr int kIterations = 4;  // any descent direction is enough, so few digits of the eigenvector are needed
  const Eigen::VectorXd no_gap = Eigen::VectorXd::Zero(eq1_.num_closures());
  for (int i = 0; i < kIterations; ++i) {
    turn = kkt_.solve(turn, no_gap).step;
    turn.array() -= turn.mean();  // removes the rotation of the whole piece
    turn /= largest(turn);
  }
  return turn;
}

/// Moves by t along a direction and closes the loops again. Returns false, with psi and value unchanged, unless the
/// value of Eq. (1) decreases by at least `decrease`.
bool InnerProblem::move(const Eigen::VectorXd& lengths, const Eigen::VectorXd& direction, double t, double decrease,
                        Eigen::VectorXd& psi, double& value) const {
  stop().check();
  Eigen::VectorXd trial = psi + t * direction;
  if (!restore(lengths, trial)) return false;
  const double trial_value = eq1_.angle_variation(trial);
  if (trial_value > value - decrease + 1e-14 * value) return false;
  psi = trial;
  value = trial_value;
  return true;
}

/// Leaves a saddle if the predicted gain is above at_least. Returns whether psi has changed. Without this function and
/// the bend in close_loops(), 2 of 1,000 random networks with a good shape fail.
bool InnerProblem::leave_saddle(const Eigen::VectorXd& lengths, const Eigen::VectorXd& closure_hessian, double at_least,
                                Eigen::VectorXd& psi, double& value) const {
  constexpr int kMaxSearches = 10;  // each takes a few substitutions
  constexpr double kClose = 0.01;   // near a saddle, at_least is below this share of the value
  // In a symmetric network, the start may contain little of a direction of negative curvature, so one search may not
  // find the direction.
  const int searches = at_least < kClose * value ? kMaxSearches : 1;
  Eigen::VectorXd turn = eq1_.symmetry_breaker();
  double fall = 0;
  for (int i = 0; i < searches && !(fall > 0); ++i) {
    turn = inverse_iteration(turn);
    // Even if the factor contains only a share of the curvature, the prediction uses the full curvature.
    fall = -turn.dot(eq1_.laplacian() * turn + closure_hessian.cwiseProduct(turn));
  }
  for (double t = kBend; fall * t * t > at_least && t > kSmallestStep; t /= 2) {
    const double predicted = kSufficientDecrease * fall * t * t / 2;
    if (move(lengths, turn, t, predicted, psi, value) || move(lengths, turn, -t, predicted, psi, value)) return true;
  }
  return false;
}

/// Minimizes Eq. (1) by feasible sequential quadratic programming: all loops stay closed in every iterate. Returns
/// whether the projected gradient vanishes and the inertia proves a minimum.
bool InnerProblem::minimize(const Eigen::VectorXd& lengths, InnerSolution& solution) {
  Eigen::VectorXd& psi = solution.psi;
  Eigen::VectorXd& multipliers = solution.multipliers;
  const Eigen::VectorXd no_gap = Eigen::VectorXd::Zero(eq1_.num_closures());
  double curvature_share = 0.5;
  double value = eq1_.angle_variation(psi);
  // Here, kkt_ still contains the factor that closed the loops, so the multipliers need no new factor.
  multipliers = kkt_.solve(-eq1_.gradient(psi), no_gap).multipliers;
  for (int i = 0; i < kMaxSteps; ++i) {
    const Eigen::VectorXd gradient = eq1_.gradient(psi);
    const Eigen::SparseMatrix<double> jacobian = eq1_.closure_jacobian(psi, lengths);
    solution.projected_gradient = largest(gradient + jacobian.transpose() * multipliers);
    const Eigen::VectorXd closure_hessian = eq1_.closure_hessian(psi, lengths, multipliers);
    const bool is_convex = factor_downhill(closure_hessian, jacobian, curvature_share);
    if (is_convex && solution.projected_gradient < kStationary) return true;

    const KktSystem::Solution newton = kkt_.solve(-gradient, no_gap);
    const auto step = [&](const Eigen::VectorXd& direction) {
      const double slope = gradient.dot(direction);
      for (double t = 1; t > kSmallestStep; t /= 2) {
        if (move(lengths, direction, t, -kSufficientDecrease * t * slope, psi, value)) return true;
      }
      return false;
    };
    const bool has_moved = is_convex ? step(newton.step)
                                     : leave_saddle(lengths, closure_hessian, -gradient.dot(newton.step), psi, value) ||
                                           step(newton.step) || leave_saddle(lengths, closure_hessian, 0, psi, value);
    if (!has_moved) return false;
    multipliers = newton.multipliers;
  }
  return false;
}

}  // namespace wirewarp
