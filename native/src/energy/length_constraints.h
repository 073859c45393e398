// SPDX-License-Identifier: GPL-3.0-or-later
// The guarantee as equations: every edge of the boundary and of a rigid or elastic wire has its length. Under a cloth
// there is one more for each connected part, last, which keeps it from turning.
//
//   c_e(u, h) = |d| − (1 + h) l,   d = u_b − u_a      h is 0 but on elastic parts, and shared evenly by their edges;
//                                                     here it is the solver's g (surface/charts/chart.h), l what is
//                                                     asked for
//   J = ∂c/∂u   row e: d̂ at b, −d̂ at a
//   T = −∂c/∂h  column w: l at the edges of the elastic parts with h_w
//   ∂²c_e/∂d² = n nᵀ / |d|,   n ⊥ d̂
//
//   c_g(u) = m·d        with a fixed m in the place of d̂; ∂²c_g/∂d² = 0
//
// Of a cloth that is worn stretched u is the layout of the stretched cloth (energy/refine_task.h), and the flat edge is
// w = S⁻¹ d:
//
//   c_e(u, h) = |w| − (1 + h) l;   ∂c_e/∂d = S⁻¹ ŵ, which is meant by d̂;   ∂²c_e/∂d² = m mᵀ / |w|³,   m ⊥ d, |m| = |d|
//   / det S
#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "energy/refine_task.h"
#include "energy/vertex_matrix.h"

namespace wirewarp {

class LengthConstraints {
 public:
  struct Edge {
    int a, b;       // chart vertices
    double length;  // l; of the row against turning: of d at first, which errors are measured against
    int elastic;    // entry of h, -1: h is 0
  };

  /// cloth: with its rows against turning, null: none; layout: one that says how long they are.
  LengthConstraints(const Chart& chart, const HeldNetwork& network, const ClothOnChart* cloth = nullptr,
                    const Positions2& layout = {});

  const std::vector<Edge>& edges() const { return edges_; }
  int size() const { return static_cast<int>(edges_.size()); }

  /// Has no curvature.
  bool is_linear(int edge) const { return edge >= size() - static_cast<int>(grain_normals_.size()); }

  /// The entry of h that a wire part of the chart has, -1 none. One for all sides of a seam that gives.
  const std::vector<int>& elastic_of_part() const { return elastic_of_part_; }
  int num_elastic() const { return static_cast<int>(tolerance_.size()); }

  /// ε. #elastic.
  const Eigen::VectorXd& tolerance() const { return tolerance_; }

  Eigen::VectorXd within_tolerance(const Eigen::VectorXd& variation) const {
    return variation.cwiseMax(-tolerance_).cwiseMin(tolerance_);
  }

  /// h that a layout has, beyond its tolerance or not. #elastic.
  Eigen::VectorXd variation(const Positions2& uv) const;

  /// T, #edges by #elastic: one entry in the row of an elastic edge.
  const Eigen::SparseMatrix<double>& elastic_lengths() const { return elastic_lengths_; }

  /// c. #edges, scene units.
  Eigen::VectorXd residual(const Positions2& uv, const Eigen::VectorXd& variation) const;

  /// Largest |c| / (l + 10⁻⁵ √area), infinite where a residual is not finite: edges so short that their ends differ by
  /// little more than the rounding of coordinates are measured against that.
  double largest_error(const Eigen::VectorXd& residual) const;

  static constexpr double exact = 1e-13;  // the target of steps to exact lengths
  static constexpr double kept = 1e-10;   // from here on a length counts as kept; the guarantee is 1e-9

  /// d̂, one row per edge; zero where an edge has no length.
  Positions2 directions(const Positions2& uv) const;

  /// λ ∂²c/∂d² of an edge; zero where it has no length.
  Eigen::Matrix2d curvature(int edge, const Positions2& uv, double multiplier) const;

  /// J d for the directions of a linearization. #edges.
  Eigen::VectorXd apply(const Positions2& directions, const Eigen::Ref<const Positions2>& d) const;

  /// Adds Jᵀ λ. One row per chart vertex.
  void add_transposed(const Positions2& directions, const Eigen::VectorXd& multipliers,
                      Eigen::Ref<Positions2> result) const;

 private:
  const Eigen::RowVector2d& grain_normal(int edge) const {
    return grain_normals_[edge - (size() - static_cast<int>(grain_normals_.size()))];
  }

  /// w.
  Eigen::RowVector2d flat_edge(const Edge& edge, const Positions2& uv) const {
    return (uv.row(edge.b) - uv.row(edge.a)).cwiseProduct(flat_share_);
  }

  std::vector<Edge> edges_;
  std::vector<int> elastic_of_part_;
  Eigen::VectorXd tolerance_;
  Eigen::SparseMatrix<double> elastic_lengths_;
  std::vector<Eigen::RowVector2d> grain_normals_;  // m
  Eigen::RowVector2d flat_share_{1, 1};            // the diagonal of S⁻¹
  double rounding_length_;                         // 10⁻⁵ √area
};

}  // namespace wirewarp
