// SPDX-License-Identifier: GPL-3.0-or-later
// The linear system of a Newton step under exact lengths,
//
//   [ H  Jᵀ ] [ d ]   [ r₁ ]      H   Hessian of f + λᵀc, made positive on demand
//   [ J  0  ] [ λ ] = [ r₂ ]      J   Jacobian of the lengths
//
// in the positive definite form A = H + 10⁻⁴ M + Jᵀ ρ J + pins. M has the lumped vertex areas of each connected part,
// relative to the area of that part. For large ρ, A has a Cholesky factor if and only if H is positive on the null
// space of J: a failed factorization is the test of the inertia. The method of multipliers (M. J. D. Powell, A method
// for nonlinear constraints in minimization problems, 1969) needs two or three solves to reach the solution for ρ → ∞.
//
// All solves but the last need d only on the wires; finish() completes the back substitution once.
//
// The length variations h of elastic parts are unknowns, too, with the springs ρ between J d and T h. They come last
// and are not eliminated, because a quadratic program chooses them within their tolerances. With d eliminated, it has
// the objective ½ h·S h − h·Tᵀλ, S = Tᵀ (ρ − ρ J A⁻¹ Jᵀ ρ) T, with λ those of h = 0. Back substitution starts from h.
#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "base/stop_token.h"
#include "energy/fair_shape_error.h"
#include "energy/length_constraints.h"
#include "numerics/cholesky/multifrontal_cholesky.h"

namespace wirewarp {

/// Which parts of the curvature of f + λᵀc H contains.
struct Convexity {
  Curvature curvature;
  bool keep_compression;  // the negative curvature of edges with λ < 0, which may buckle
};

/// Returns a symmetric matrix unchanged if it is well positive, and otherwise with the magnitudes of its eigenvalues,
/// none below 1e-6 of the largest, so that the quadratic model has a minimum. A matrix of more than 200 rows gets a
/// larger diagonal instead.
Eigen::MatrixXd make_positive(const Eigen::MatrixXd& symmetric);

class NewtonSystem {
 public:
  /// The objective and the constraints must outlive the system. positions: any layout that separates near vertices from
  /// far ones, for the order of elimination. Throws Stopped.
  NewtonSystem(const Chart& chart, FairShapeError& objective, const LengthConstraints& constraints,
               const Positions2& positions, const StopToken& stop = {});

  /// The stiffness ρ, one per edge, used from the next factorization on. The default is large enough to keep the
  /// lengths.
  const Eigen::VectorXd& stiffness() const { return stiffness_; }
  void set_stiffness(Eigen::VectorXd stiffness) { stiffness_ = std::move(stiffness); }

  /// Linearizes at uv. Returns false if A is not positive definite, or if the caller stops. multipliers: λ, one per
  /// edge.
  bool factorize(const Positions2& uv, const Eigen::VectorXd& multipliers, const Convexity& convexity,
                 const StopToken& stop = {});

  /// Returns H + 10⁻⁴ M + pins at uv for products with vectors: the lower triangle, without the unknowns h.
  Eigen::SparseMatrix<double> hessian(const Positions2& uv, const Eigen::VectorXd& multipliers,
                                      const Convexity& convexity);

  /// Returns the size of a vector d with the unknowns h.
  Eigen::Index num_unknowns() const { return matrix_.lower().rows(); }

  /// A right-hand side after forward substitution, before h is chosen.
  struct Reduced {
    Eigen::VectorXd d;     // after forward substitution; x of each vertex, then its y
    Eigen::VectorXd pull;  // Tᵀλ for h = 0, #elastic
    Eigen::VectorXd r2;
  };

  /// A solution factor of A d = r₁ + Jᵀ τ on the wires. d has x of each vertex, then its y. Off the wires, it has
  /// intermediate values for finish(), which accepts sums of such d, too.
  struct Solution {
    Eigen::VectorXd d;
    Eigen::VectorXd tensions;     // τ
    Eigen::VectorXd multipliers;  // λ
  };

  /// r1: one row per chart vertex; r2: #edges.
  Reduced reduce(const Positions2& r1, const Eigen::VectorXd& r2) const;

  /// Returns d on the wires and λ to nine digits; J d is r₂ + T h.
  Solution solve_on_wires(const Reduced& reduced, const Eigen::VectorXd& variation) const;

  /// The same for h = 0.
  Solution solve_on_wires(const Positions2& r1, const Eigen::VectorXd& r2) const;

  /// Returns d everywhere and λ by one solve, to about five digits.
  Solution solve_roughly(const Reduced& reduced, const Eigen::VectorXd& variation) const;

  /// S of the last factorization, #elastic by #elastic: the stiffness of the springs ρ against changes of h if d
  /// follows h. It is ∂(−Tᵀλ)/∂h to about five digits if ρ keeps the lengths.
  const Eigen::MatrixXd& stiffness_by_variation() const { return stiffness_h_; }

  /// Returns the change of h within its tolerances that minimizes the quadratic model with d eliminated. pull: minus
  /// the gradient by h, #elastic.
  Eigen::VectorXd choose_variation_change(const Eigen::VectorXd& pull, const Eigen::VectorXd& variation) const;

  /// Returns the least d in the metric H with J d = r2, on the wires, to the accuracy of one solve.
  Eigen::VectorXd least_change(const Eigen::VectorXd& r2) const;

  /// Completes the back substitution. Returns d everywhere.
  Positions2 finish(const Eigen::VectorXd& d_on_wires) const;

  /// Returns A⁻¹ b, one row per chart vertex.
  Positions2 apply_inverse(const Positions2& b) const;

  /// Returns the directions d̂ of the linearization.
  const Positions2& directions() const { return directions_; }

  int num_factorizations() const { return num_factorizations_; }

 private:
  void assemble(const Positions2& uv, const Eigen::VectorXd& multipliers, const Convexity& convexity,
                double stiffness_share);
  void add_elastic_springs(double stiffness_share);
  Solution solve(const Reduced& reduced, const Eigen::VectorXd& variation, const FrontSet& wanted) const;
  Eigen::VectorXd response(const Eigen::VectorXd& tensions) const;
  Eigen::VectorXd changes_of_length(const Eigen::VectorXd& d) const;
  double relative_motion(const Eigen::VectorXd& d) const;
  void improve(const Eigen::VectorXd& r2, Solution& solution) const;

  FairShapeError& objective_;
  const LengthConstraints& constraints_;
  VertexMatrix matrix_;
  std::vector<VertexPair> pinned_;  // per connected part, against rigid motions: the first cannot move, the second
                                    // cannot turn about it
  std::vector<VertexMatrix::Block> edge_blocks_;
  std::vector<std::array<VertexMatrix::Block, 2>> elastic_blocks_;  // h with the ends a, b of each elastic edge
  Eigen::Index num_positions_;                                      // number of unknowns before h
  Eigen::ArrayXd constant_;      // values of L + the Hessian of F + 10⁻⁴ M + the pins that do not depend on uv
  Eigen::VectorXd stiffness_;    // ρ
  Eigen::MatrixXd stiffness_h_;  // S
  Positions2 directions_;        // d̂
  std::optional<MultifrontalCholesky> cholesky_;  // of A
  FrontSet on_wires_, off_wires_;
  int num_factorizations_ = 0;
};

}  // namespace wirewarp
