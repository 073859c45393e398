// SPDX-License-Identifier: GPL-3.0-or-later
// The local step finds all rotations for the shape, the global step the shape for these rotations, which is the minimum
// of a quadratic with the constant Hessian K. Its gradient at u is that of E, so both are one step u -= K⁻¹ ∂E/∂u.
#include "outer/free_arap.h"

#include <Eigen/SparseCholesky>
#include <stdexcept>
#include <utility>
#include <vector>

#include "outer/circle_embedding.h"
#include "outer/shape_error.h"

namespace wirewarp {
namespace {

constexpr double kSmallestDrop = 1e-6;   // of E in a step, over E
constexpr double kRegularization = 1e-12;  // of the diagonal: far above rounding, so that a sliver cannot fail it

class GlobalStep {
 public:
  /// Doubling one diagonal entry of K holds its vertex: the entries of a gradient sum to 0, so the vertex does not move.
  explicit GlobalStep(Eigen::SparseMatrix<double> hessian) {
    hessian.coeffRef(0, 0) *= 2;
    hessian.diagonal() *= 1 + kRegularization;
    llt_.compute(hessian);
    if (llt_.info() != Eigen::Success) throw std::domain_error("GlobalStep: the Laplacian is not positive definite");
  }

  /// b := K⁻¹ b, both columns in one sweep over the factor.
  void solve(Positions2& b) const {
    using Pair = Eigen::Array2d;
    const Eigen::SparseMatrix<double>& l = llt_.matrixL().nestedExpression();
    const auto& pivot_of_vertex = llt_.permutationP().indices();
    const int* begin = l.outerIndexPtr();
    const int* rows = l.innerIndexPtr();
    const double* values = l.valuePtr();
    std::vector<Pair> x(b.rows());
    for (Eigen::Index v = 0; v < b.rows(); ++v) x[pivot_of_vertex[v]] = b.row(v).transpose();
    for (Eigen::Index k = 0; k < l.cols(); ++k) {  // a column's first entry is its pivot
      const Pair x_k = x[k] /= values[begin[k]];
      for (int e = begin[k] + 1; e < begin[k + 1]; ++e) x[rows[e]] -= values[e] * x_k;
    }
    for (Eigen::Index k = l.cols(); k-- > 0;) {
      Pair x_k = x[k];
      for (int e = begin[k] + 1; e < begin[k + 1]; ++e) x_k -= values[e] * x[rows[e]];
      x[k] = x_k / values[begin[k]];
    }
    for (Eigen::Index v = 0; v < b.rows(); ++v) b.row(v) = x[pivot_of_vertex[v]].transpose();
  }

 private:
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> llt_;  // approximate minimum degree
};

/// What the boundary loops enclose, holes taken off; negative in a mirror image.
double signed_area(const Chart& chart, const Positions2& uv) {
  double twice_area = 0;
  for (const HalfEdgeChain& loop : chart.boundary_loops) {
    for (const HalfedgeHandle h : loop) {
      const auto a = uv.row(chart.mesh.from_vertex_handle(h).idx()), b = uv.row(chart.mesh.to_vertex_handle(h).idx());
      twice_area += a.x() * b.y() - a.y() * b.x();
    }
  }
  return twice_area / 2;
}

}  // namespace

FreeFlattening flatten_freely(const Chart& chart, int max_iterations, const std::optional<Positions2>& start) {
  FreeFlattening flat;
  flat.uv = start ? *start : embed_on_circle(chart);
  if (signed_area(chart, flat.uv) < 0) flat.uv.col(0) *= -1;

  const ShapeError shape_error(chart);
  const GlobalStep global_step(shape_error.fixed_rotation_hessian());
  flat.factorizations = start ? 1 : 2;

  Positions2 step;  // first the gradient
  flat.energy = shape_error.energy_and_gradient(flat.uv, step);
  while (flat.iterations < max_iterations && !flat.converged) {
    ++flat.iterations;
    global_step.solve(step);
    Positions2 uv = flat.uv - step;
    const double energy = shape_error.energy_and_gradient(uv, step);
    flat.converged = !(flat.energy - energy > kSmallestDrop * flat.energy);
    if (!(energy < flat.energy)) break;  // by rounding
    flat.uv = std::move(uv);
    flat.energy = energy;
  }
  return flat;
}

}  // namespace wirewarp
