// SPDX-License-Identifier: GPL-3.0-or-later
// The linear system of a Newton step under exact lengths,
//
//   [ H  Jᵀ ] [ d ]   [ r₁ ]      H   Hessian of f + λᵀc, made positive where that is asked for
//   [ J  0  ] [ λ ] = [ r₂ ]      J   Jacobian of the lengths
//
// in the positive definite form A = H + 10⁻⁴ M + Jᵀ ρ J + pins, with M the lumped areas over the whole area, of each
// connected part. For large ρ, A has a Cholesky factor exactly where H is positive on the null space of J: a failed
// factorization is the test of the inertia. The method of multipliers takes two or three solves with it to the solution
// for ρ → ∞ (M. J. D. Powell, A method for nonlinear constraints in minimization problems, 1969).
//
// All of them but the last need d on the wires only: back substitution goes on from there once, in finish().
//
// The length variations h of elastic parts are unknowns, too, with the springs ρ between J d and T h. They come last
// and are not eliminated, for a quadratic program has to choose them within their tolerances: with d eliminated, what
// is left is ½ h·S h − h·Tᵀλ, S = Tᵀ (ρ − ρ J A⁻¹ Jᵀ ρ) T and λ those of h = 0. Back substitution then starts from h.
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

/// What of the curvature of f + λᵀc goes into H.
struct Convexity {
  Curvature curvature;
  bool keep_compression;  // the negative curvature of edges with λ < 0, which may buckle
};

/// A symmetric matrix as it is where it is well positive; else with the magnitudes of its eigenvalues, none below 1e-6
/// of the largest: a model that has a minimum. One of more than 200 rows gets a larger diagonal instead.
Eigen::MatrixXd make_positive(const Eigen::MatrixXd& symmetric);

class NewtonSystem {
 public:
  /// objective, constraints: must outlive the system. positions: any layout that separates near vertices from far ones,
  /// for the order of elimination. Throws Stopped.
  NewtonSystem(const Chart& chart, FairShapeError& objective, const LengthConstraints& constraints,
               const Positions2& positions, const StopToken& stop = {});

  /// ρ, #edges, from the next factorization on. By default so large that lengths are held.
  const Eigen::VectorXd& stiffness() const { return stiffness_; }
  void set_stiffness(Eigen::VectorXd stiffness) { stiffness_ = std::move(stiffness); }

  /// Linearizes at uv; false where A is not positive definite, or the caller stops. multipliers: λ, #edges.
  bool factorize(const Positions2& uv, const Eigen::VectorXd& multipliers, const Convexity& convexity,
                 const StopToken& stop = {});

  /// H at uv, with 10⁻⁴ M and the pins, to multiply with; lower triangle, positions alone.
  Eigen::SparseMatrix<double> hessian(const Positions2& uv, const Eigen::VectorXd& multipliers,
                                      const Convexity& convexity);

  /// Numbers of a d: of positions and of h.
  Eigen::Index num_unknowns() const { return matrix_.lower().rows(); }

  /// The way forward: a solution but for the h that is to be chosen.
  struct Reduced {
    Eigen::VectorXd d;     // substituted forward, x and y of each vertex below one another
    Eigen::VectorXd pull;  // Tᵀλ for h = 0, #elastic
    Eigen::VectorXd r2;
  };

  /// A solution on its way: A d = r₁ + Jᵀ τ on the wires, x and y of each vertex below one another. Elsewhere d holds
  /// what finish() needs, and so do sums of such d.
  struct Solution {
    Eigen::VectorXd d;
    Eigen::VectorXd tensions;     // τ
    Eigen::VectorXd multipliers;  // λ
  };

  /// r1: one row per chart vertex; r2: #edges.
  Reduced reduce(const Positions2& r1, const Eigen::VectorXd& r2) const;

  /// d on the wires and λ, J d being r₂ + T h, to nine digits.
  Solution solve_on_wires(const Reduced& reduced, const Eigen::VectorXd& variation) const;

  /// The same for h = 0.
  Solution solve_on_wires(const Positions2& r1, const Eigen::VectorXd& r2) const;

  /// d everywhere and λ by one solve, to about five digits.
  Solution solve_roughly(const Reduced& reduced, const Eigen::VectorXd& variation) const;

  /// S of the last factorization: how the springs ρ of the edges resist h, where d follows them. With ρ that hold the
  /// lengths to about five digits ∂(−Tᵀλ)/∂h. #elastic by #elastic.
  const Eigen::MatrixXd& stiffness_by_variation() const { return stiffness_h_; }

  /// d on the wires with J d = r2, the least in the metric H, to the accuracy of one solve.
  Eigen::VectorXd least_change(const Eigen::VectorXd& r2) const;

  /// d everywhere.
  Positions2 finish(const Eigen::VectorXd& d_on_wires) const;

  /// A⁻¹ b. One row per chart vertex.
  Positions2 apply_inverse(const Positions2& b) const;

  /// d̂ of the linearization.
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
  std::vector<VertexPair> pinned_;  // one a connected part, hold its rigid motions: the first altogether, the second
                                    // against turning
  std::vector<VertexMatrix::Block> edge_blocks_;
  std::vector<std::array<VertexMatrix::Block, 2>> elastic_blocks_;  // of h and the ends a, b of each elastic edge
  Eigen::Index num_positions_;                                      // unknowns before h
  Eigen::ArrayXd constant_;      // values of L + the Hessian of F + 10⁻⁴ M + the pin that never turns
  Eigen::VectorXd stiffness_;    // ρ
  Eigen::MatrixXd stiffness_h_;  // S
  Positions2 directions_;        // d̂
  std::optional<MultifrontalCholesky> cholesky_;  // of A
  FrontSet on_wires_, off_wires_;
  int num_factorizations_ = 0;
};

}  // namespace wirewarp
