// SPDX-License-Identifier: GPL-3.0-or-later
// A quadratic function of the positions of a chart's vertices that does not change if the chart is translated:
//
//   Q(u) = ½ Σ w |r|²,  r = Σ_k T_k u_k over the vertices of a term,  Σ_k T_k = 0
//
// Q is computed from r, not from its Hessian. Short edges make entries of the Hessian 1e8 times as large as Q, so their
// rounding errors would be too large.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "energy/vertex_matrix.h"

namespace wirewarp {

/// Factor: the type of T_k, a number or a 2 by 2 matrix. kSize: number of vertices of a term.
template <class Factor, std::size_t kSize>
class QuadraticForm {
 public:
  /// Any two vertices of a term have a common face, except perhaps the last two. The caller lists the edges of all
  /// faces, so list_pairs() lists only the last two vertices. They may be equal.
  struct Term {
    std::array<int, kSize> vertices;
    std::array<Factor, kSize> factors;
    double weight;

    Eigen::Vector2d residual(const Positions2& uv) const {
      // Differences are computed first, because positions may be far larger than edges.
      Eigen::Vector2d sum = Eigen::Vector2d::Zero();
      for (std::size_t k = 1; k < kSize; ++k)
        sum += factors[k] * (uv.row(vertices[k]) - uv.row(vertices[0])).transpose();
      return sum;
    }
  };

  explicit QuadraticForm(std::vector<Term> terms) : terms_(std::move(terms)) {}

  /// Returns Q. uv: one row per chart vertex.
  double value(const Positions2& uv) const {
    double sum = 0;
    for (const Term& term : terms_) sum += term.weight * term.residual(uv).squaredNorm();
    return sum / 2;
  }

  /// Returns Q, and adds ∂Q/∂u to the gradient, one row per chart vertex.
  double add_gradient(const Positions2& uv, Positions2& gradient) const {
    double sum = 0;
    for (const Term& term : terms_) {
      const Eigen::Vector2d r = term.residual(uv);
      for (std::size_t k = 0; k < kSize; ++k) {
        gradient.row(term.vertices[k]) += pull(term.factors[k], term.weight, r).transpose();
      }
      sum += term.weight * r.squaredNorm();
    }
    return sum / 2;
  }

  /// Returns the Q that rounding causes in a layout with Q = 0. error: about the error of each coordinate.
  double value_of_rounding(double error) const {
    double sum = 0;
    for (const Term& term : terms_) {
      for (const Factor& factor : term.factors) sum += term.weight * matrix_of(factor).squaredNorm();
    }
    return error * error * sum / 2;
  }

  /// Appends the pairs of coupled vertices that may have no common face.
  void list_pairs(std::vector<VertexPair>& pairs) const {
    for (const Term& term : terms_) pairs.push_back({term.vertices[kSize - 2], term.vertices[kSize - 1]});
  }

  /// Adds the Hessian, which is constant and positive semidefinite.
  void add_hessian(VertexMatrix& hessian) const {
    for (const Term& term : terms_) {
      for (std::size_t i = 0; i < kSize; ++i) {
        for (std::size_t j = 0; j < kSize; ++j) {
          const int row = term.vertices[i], column = term.vertices[j];
          const Eigen::Matrix2d block =
              term.weight * matrix_of(term.factors[i]).transpose() * matrix_of(term.factors[j]);
          if (row > column) hessian.add(hessian.block(row, column), block);
          if (row == column) hessian.add_diagonal(row, block);  // correct even if a vertex is in a term twice
        }
      }
    }
  }

 private:
  static Eigen::Vector2d pull(double factor, double weight, const Eigen::Vector2d& r) { return weight * factor * r; }
  static Eigen::Vector2d pull(const Eigen::Matrix2d& factor, double weight, const Eigen::Vector2d& r) {
    return factor.transpose() * (weight * r);
  }
  static Eigen::Matrix2d matrix_of(double factor) { return factor * Eigen::Matrix2d::Identity(); }
  static Eigen::Matrix2d matrix_of(const Eigen::Matrix2d& factor) { return factor; }

  std::vector<Term> terms_;
};

}  // namespace wirewarp
