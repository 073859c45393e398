// SPDX-License-Identifier: GPL-3.0-or-later
// The linear system of a Newton step under exact lengths,
//
//   [ H  Jᵀ ] [ d ]   [ r₁ ]      H   Hessian of f + λᵀc, made positive on demand
//   [ J  0  ] [ λ ] = [ r₂ ]      J   Jacobian of the lengths
//
// in the positive definite form A = H + 10⁻⁴ M + Jᵀ ρ J + pins. The pins are springs against rigid motions. M has the
// lumped vertex areas of each connected part, relative to the area of that part. For large ρ, A has a Cholesky factor
// if and only if H is positive on the null space of J. So the factorization also tests the inertia. The method of
// multipliers (M. J. D. Powell, A method for nonlinear constraints in minimization problems, 1969) needs two or three
// solves with A to find the solution for infinite ρ.
//
// All solves except the last need d only on the wires. finish() completes the back substitution of the last solve.
//
// The length variations h of elastic parts are unknowns, too; the springs ρ connect J d with T h. The h come last and
// are not eliminated, because a quadratic program chooses them within their tolerances. With d eliminated, its
// objective is ½ h·S h − h·Tᵀλ with S = Tᵀ (ρ − ρ J A⁻¹ Jᵀ ρ) T and the λ of h = 0. Back substitution starts from h.
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

/// The parts of the curvature of f + λᵀc that H contains.
struct Convexity {
  Curvature curvature;
  bool keep_compression;  // whether H contains the negative curvature of compressed edges (λ < 0), which may buckle
};

inline constexpr Convexity kExactHessian{Curvature::exact, true};
inline constexpr Convexity kConvexHessian{Curvature::convex, false};
inline constexpr Convexity kLaplacian{Curvature::none, false};

/// Returns a positive definite matrix near a symmetric matrix. A clearly positive definite matrix stays unchanged.
/// Otherwise, eigenvalues become their magnitudes or, with more than 200 rows, the diagonal is increased.
Eigen::MatrixXd make_positive(const Eigen::MatrixXd& symmetric);

class NewtonSystem {
 public:
  /// The objective and the constraints must outlive the system. positions: any layout in which neighboring vertices
  /// are near each other; determines the order of elimination. Throws Stopped.
  NewtonSystem(const Chart& chart, FairShapeError& objective, const LengthConstraints& constraints,
               const Positions2& positions, const StopToken& stop = {});

  /// Return or set the stiffness ρ, one per edge. A new stiffness applies from the next factorization on. The default
  /// is large enough to keep the lengths.
  const Eigen::VectorXd& stiffness() const { return stiffness_; }
  void set_stiffness(Eigen::VectorXd stiffness) { stiffness_ = std::move(stiffness); }

  /// Linearizes at uv. Returns false if A is not positive definite, or if the caller stops. multipliers: λ, one per
  /// edge.
  bool factorize(const Positions2& uv, const Eigen::VectorXd& multipliers, const Convexity& convexity,
                 const StopToken& stop = {});

  /// Returns the lower triangle of H + 10⁻⁴ M + pins at uv, without the unknowns h, for products with vectors.
  Eigen::SparseMatrix<double> hessian(const Positions2& uv, const Eigen::VectorXd& multipliers,
                                      const Convexity& convexity);

  /// Returns the number of unknowns, including h.
  Eigen::Index num_unknowns() const { return matrix_.lower().rows(); }

  /// A right-hand side after forward substitution, before h is chosen.
  struct Reduced {
    Eigen::VectorXd d;     // x and y of each vertex in turn, then the rows of h
    Eigen::VectorXd pull;  // Tᵀλ for h = 0, one per elastic part
    Eigen::VectorXd r2;
  };

  /// A solution of A d = r₁ + Jᵀ τ on the wires, with x and y of each vertex in turn. finish() computes d at the other
  /// vertices. It also accepts sums of several d.
  struct Solution {
    Eigen::VectorXd d;
    Eigen::VectorXd tensions;     // τ
    Eigen::VectorXd multipliers;  // λ
  };

  /// Substitutes the right-hand side r₁, r₂ forward. r1: one row per chart vertex. r2: one per edge.
  Reduced reduce(const Positions2& r1, const Eigen::VectorXd& r2) const;

  /// Returns d on the wires, and λ. J d = r₂ + T h holds to nine digits. variation: h.
  Solution solve_on_wires(const Reduced& reduced, const Eigen::VectorXd& variation) const;

  /// Returns d on the wires and λ for h = 0.
  Solution solve_on_wires(const Positions2& r1, const Eigen::VectorXd& r2) const;

  /// Returns d everywhere, and λ, both to about five digits, by one solve.
  Solution solve_roughly(const Reduced& reduced, const Eigen::VectorXd& variation) const;

  /// Returns S of the last factorization, one row and column per elastic part: the stiffness against changes of h if d
  /// follows h. If ρ keeps the lengths, S is ∂(−Tᵀλ)/∂h to about five digits.
  const Eigen::MatrixXd& stiffness_by_variation() const { return stiffness_h_; }

  /// Returns the change of h within its tolerances that minimizes the quadratic model with d eliminated. pull: negative
  /// gradient with respect to h, one per elastic part. variation: the current h.
  Eigen::VectorXd choose_variation_change(const Eigen::VectorXd& pull, const Eigen::VectorXd& variation) const;

  /// Returns, on the wires, the d with J d = r2 that is smallest in the metric H, to the accuracy of one solve.
  Eigen::VectorXd least_change(const Eigen::VectorXd& r2) const;

  /// Completes the back substitution. Returns d everywhere.
  Positions2 finish(const Eigen::VectorXd& d_on_wires) const;

  /// Returns A⁻¹ b, one row per chart vertex.
  Positions2 apply_inverse(const Positions2& b) const;

  /// Returns the directions d̂ of the edges at the last linearization, one row per edge.
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
  std::vector<VertexPair> pinned_;  // per connected part, against rigid motions: the first vertex cannot move, the
                                    // second cannot turn about the first
  std::vector<VertexMatrix::Block> edge_blocks_;
  std::vector<std::array<VertexMatrix::Block, 2>> elastic_blocks_;  // couple h of each elastic edge with its ends
  Eigen::Index num_positions_;                                      // number of unknowns before h
  /// The matrix values that do not depend on uv. They include 10⁻⁴ M and the pin of the first vertex of each pair.
  Eigen::ArrayXd constant_;
  Eigen::VectorXd stiffness_;                     // ρ
  Eigen::MatrixXd stiffness_h_;                   // S
  Positions2 directions_;                         // d̂
  std::optional<MultifrontalCholesky> cholesky_;  // of A
  FrontSet on_wires_, off_wires_;
  int num_factorizations_ = 0;
};

}  // namespace wirewarp
