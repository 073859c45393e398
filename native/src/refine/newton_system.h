// SPDX-License-Identifier: GPL-3.0-or-later
// The linear system of a Newton step under exact lengths,
//
//   [ H  Jᵀ ] [ d ]   [ r₁ ]      H   Hessian of f + λᵀc, made positive where that is asked for
//   [ J  0  ] [ λ ] = [ r₂ ]      J   Jacobian of the lengths
//
// in the positive definite form A = H + 10⁻⁴ M + Jᵀ ρ J + pins, with M the lumped areas over the whole area, of each
// connected part. For large
// ρ, A has a Cholesky factor exactly where H is positive on the null space of J: a failed factorization is the test of
// the inertia. The method of multipliers takes two or three solves with it to the solution for ρ → ∞ (M. J. D. Powell,
// A method for nonlinear constraints in minimization problems, 1969).
//
// All of them but the last need d on the wires only: back substitution goes on from there once, in finish().
#pragma once

#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "cholesky/multifrontal_cholesky.h"
#include "refine/fair_shape_error.h"
#include "refine/length_constraints.h"
#include "stop_token.h"

namespace wirewarp {

/// What of the curvature of f + λᵀc goes into H.
struct Convexity {
  Curvature curvature;
  bool keep_compression;  // the negative curvature of edges with λ < 0, which may buckle
};

/// A symmetric matrix as it is where it is well positive; else with the magnitudes of its eigenvalues, none below 1e-6
/// of the largest: a model that has a minimum. One of more than 200 rows gets a larger diagonal instead.
Eigen::MatrixXd make_positive(const Eigen::MatrixXd& symmetric);

/// S = −Tᵀ ∂λ/∂h: the Hessian by h of the least q(d) = g·d + ½ d·Hd with J d = T h. lengths: T; multipliers: ∂λ/∂h.
Eigen::MatrixXd hessian_h(const Eigen::SparseMatrix<double>& lengths, const Eigen::MatrixXd& multipliers);

class NewtonSystem {
 public:
  /// objective, constraints: must outlive the system. positions: any layout that tells near vertices from far ones,
  /// for the order of elimination. Throws Stopped.
  NewtonSystem(const Chart& chart, FairShapeError& objective, const LengthConstraints& constraints,
               const Positions2& positions, const StopToken& stop = {});

  /// ρ, #edges, from the next factorization on. By default so large that lengths are held.
  const Eigen::VectorXd& stiffness() const { return stiffness_; }
  void set_stiffness(Eigen::VectorXd stiffness) { stiffness_ = std::move(stiffness); }

  /// Linearizes at uv; false where A is not positive definite, or the caller stops. multipliers: λ, #edges.
  bool factorize(const Positions2& uv, const Eigen::VectorXd& multipliers, const Convexity& convexity,
                 const StopToken& stop = {});

  /// H at uv, with 10⁻⁴ M and the pins, to multiply with; lower triangle.
  Eigen::SparseMatrix<double> hessian(const Positions2& uv, const Eigen::VectorXd& multipliers,
                                      const Convexity& convexity);

  /// Solutions on their way, one a column: A d = r₁ + Jᵀ τ on the wires, x and y of each vertex below one another.
  /// Elsewhere d holds what finish() needs, and so do sums of such d.
  struct Solution {
    Eigen::MatrixXd d;
    Eigen::MatrixXd tensions;     // τ
    Eigen::MatrixXd multipliers;  // λ
  };

  /// d on the wires and λ by one solve, to about five digits. r1: one row per chart vertex; r2: #edges.
  Solution solve_roughly(const Positions2& r1, const Eigen::VectorXd& r2) const;

  /// Goes on to nine digits, or to another r₂, the multipliers being a guess.
  void improve(const Eigen::MatrixXd& r2, Solution& solution) const;

  /// Both: d on the wires and λ.
  Solution solve_on_wires(const Positions2& r1, const Eigen::VectorXd& r2) const;

  /// ∂λ/∂h for all elastic parts, J d being T h, to about five digits. #edges by #elastic; zero in the
  /// columns that are left where the caller stops.
  Eigen::MatrixXd dlambda_dh(const StopToken& stop = {}) const;

  /// Tᵀ (ρ − ρ J A⁻¹ Jᵀ ρ) T: how the springs ρ of the edges resist Δh, where d follows them. #elastic by #elastic.
  Eigen::MatrixXd stiffness_by_variation() const;

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
  std::set<int> parts_of_column(int w) const;
  std::vector<std::vector<int>> columns_apart() const;
  Eigen::MatrixXd response(const Eigen::MatrixXd& tensions) const;
  Eigen::MatrixXd changes_of_length(const Eigen::MatrixXd& d) const;
  double relative_motion(const Eigen::MatrixXd& d) const;
  void improve(const Eigen::MatrixXd& r2, double accuracy, Solution& solution) const;

  FairShapeError& objective_;
  const LengthConstraints& constraints_;
  VertexMatrix matrix_;
  std::vector<VertexPair> pinned_;  // one a connected part, hold its rigid motions: the first altogether, the second
                                    // against turning
  std::vector<int> part_of_edge_;   // the connected part of each edge whose length is held
  std::vector<VertexMatrix::Block> edge_blocks_;
  Eigen::ArrayXd constant_;    // values of L + the Hessian of F + 10⁻⁴ M + the pin that never turns
  Eigen::VectorXd stiffness_;  // ρ
  Positions2 directions_;      // d̂
  std::optional<MultifrontalCholesky> cholesky_;  // of A
  FrontSet on_wires_, off_wires_;
  int num_factorizations_ = 0;
};

}  // namespace wirewarp
