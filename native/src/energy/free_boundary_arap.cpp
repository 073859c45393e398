// SPDX-License-Identifier: GPL-3.0-or-later
// The local step finds the best rotations for a shape, and the global step the best shape for these rotations. The
// global step minimizes a quadratic with the constant Hessian K and the gradient g = ∂E/∂u. Both steps together are
// -K⁻¹g: steepest descent in the metric K. The steps here are conjugate gradients in this metric (Polak-Ribière):
//
//   s = K⁻¹g,   d = -s + β d_before,   β = max(0, (g - g_before)·s / g_before·s_before)
#include "energy/free_boundary_arap.h"

#include <algorithm>
#include <utility>

#include "base/factorization_failed.h"
#include "base/in_threads.h"
#include "energy/shape_error.h"
#include "energy/tutte_embedding.h"
#include "numerics/cholesky/matrix_graph.h"
#include "numerics/cholesky/multifrontal_cholesky.h"
#include "surface/charts/enclosed_area.h"

namespace wirewarp {
namespace {

// The steps end once a step lowers E by a smaller share than this. A start needs no more digits.
constexpr double kSmallestDrop = 1e-6;
// The longest step, in multiples of the direction. Farther away, E differs too much from a parabola.
constexpr double kLongestStep = 8;
/// Relative increase of each diagonal entry. It is far above rounding errors, so that the factorization does not fail
/// on slivers.
constexpr double kRegularization = 1e-12;

class GlobalStep {
 public:
  /// Doubles a diagonal entry of K, because K is singular. This only fixes one vertex at 0, because entries of a
  /// gradient sum to 0. positions: any layout; determines the elimination order.
  GlobalStep(Eigen::SparseMatrix<double> hessian, const Positions2& positions, const StopToken& stop)
      : cholesky_(hessian, nested_dissection(graph_of(hessian, 1), positions), 1, has_second_core()) {
    hessian.coeffRef(0, 0) *= 2;
    hessian.diagonal() *= 1 + kRegularization;
    stop.check();
    const bool is_positive = cholesky_.factorize(hessian, stop);
    if (stop.is_stopped()) throw Stopped();
    if (!is_positive) throw FactorizationFailed("GlobalStep: the Laplacian is not positive definite");
  }

  Positions2 solve(const Positions2& b) const {
    Eigen::MatrixXd x = b;
    cholesky_.solve_in_place(x);
    return x;
  }

 private:
  MultifrontalCholesky cholesky_;
};

double dot(const Positions2& a, const Positions2& b) { return (a.array() * b.array()).sum(); }

/// Returns the step to the minimum of a parabola, in multiples of the direction; at most kLongestStep. The parabola has
/// the value and slope of E at the start, and the value of E at the start plus the direction. If the parabola has no
/// minimum, the step is kLongestStep.
double step_length(const ShapeError& shape_error, const FreeBoundaryArap& flat, const Positions2& direction,
                   double slope) {
  const double curvature = 2 * (shape_error.energy(flat.uv + direction) - flat.energy - slope);
  return curvature > 0 ? std::min(-slope / curvature, kLongestStep) : kLongestStep;
}

}  // namespace

FreeBoundaryArap free_boundary_arap(const Chart& chart, int max_iterations, const std::optional<Positions2>& start,
                                    const StopToken& stop) {
  FreeBoundaryArap flat;
  flat.uv = start ? *start : tutte_embedding(chart, stop);
  if (enclosed_area(chart, flat.uv) < 0) flat.uv.col(0) *= -1;

  stop.check();
  const ShapeError shape_error(chart);
  const GlobalStep global_step(shape_error.fixed_rotation_hessian(), flat.uv, stop);
  flat.factorizations = start ? 1 : 2;

  Positions2 gradient, other_gradient = Positions2::Zero(flat.uv.rows(), 2);  // the gradients before and after a step
  flat.energy = shape_error.energy_and_gradient(flat.uv, gradient);
  Positions2 direction = Positions2::Zero(flat.uv.rows(), 2);
  double decrease = 1;  // g·s of the previous step
  while (flat.iterations < max_iterations && !flat.converged) {
    stop.check();
    ++flat.iterations;
    const Positions2 step = global_step.solve(gradient);
    const double beta = std::max(0.0, dot(gradient - other_gradient, step) / decrease);
    decrease = dot(gradient, step);
    direction = beta * direction - step;
    Positions2 uv = flat.uv + step_length(shape_error, flat, direction, dot(gradient, direction)) * direction;
    double energy = shape_error.energy_and_gradient(uv, other_gradient);
    if (!(energy < flat.energy)) {  // plain local/global step, which cannot increase E
      direction = -step;
      uv = flat.uv + direction;
      energy = shape_error.energy_and_gradient(uv, other_gradient);
    }
    flat.converged = !(flat.energy - energy > kSmallestDrop * flat.energy);
    if (!(energy < flat.energy)) break;  // only rounding errors are left
    flat.uv = std::move(uv);
    flat.energy = energy;
    std::swap(gradient, other_gradient);
  }
  return flat;
}

}  // namespace wirewarp
