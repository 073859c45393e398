// SPDX-License-Identifier: GPL-3.0-or-later
// The guaranteed lengths as constraints: every edge of the boundary and of a rigid or elastic wire has its length. If
// the layout is not free to rotate, one more constraint for each connected part fixes the rotation of this part. These
// constraints come last.
//
//   c_e(u, h) = |d| − (1 + h) l,   d = u_b − u_a      h is 0 except on elastic parts, whose edges share one h;
//                                                     h is called g in surface/charts/chart.h, l is the
//                                                     target length
//   J = ∂c/∂u   row e: d̂ at b, −d̂ at a
//   T = −∂c/∂h  column w: l at the edges of the elastic parts with h_w
//   ∂²c_e/∂d² = n nᵀ / |d|,   n ⊥ d̂
//
//   c(u) = m·d          fixes the rotation, with a constant m instead of d̂; ∂²c/∂d² = 0
//
// For a fabric that is stretched when worn, u is the layout of the stretched fabric (energy/target_lengths.h), and the
// flat edge is w = S⁻¹ d:
//
//   c_e(u, h) = |w| − (1 + h) l
//   ∂c_e/∂d = S⁻¹ ŵ, called d̂ below
//   ∂²c_e/∂d² = m mᵀ / |w|³,   m ⊥ d, |m| = |d| / det S
#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "energy/target_lengths.h"
#include "energy/vertex_matrix.h"
#include "surface/network/wire_network.h"

namespace wirewarp {

class LengthConstraints {
 public:
  struct Edge {
    int a, b;       // chart vertices
    double length;  // l; for a constraint on the rotation, the initial length of d, which scales the error
    int elastic;    // index into h; -1 if h is 0
  };

  /// targets: null for nominal lengths in a layout that is free to rotate. layout: determines the scale of the
  /// constraints on the rotation.
  LengthConstraints(const Chart& chart, const HeldNetwork& network, const TargetLengths* targets = nullptr,
                    const Positions2& layout = {});

  const std::vector<Edge>& edges() const { return edges_; }
  int size() const { return static_cast<int>(edges_.size()); }

  bool are_free_to_turn() const { return grain_normals_.empty(); }

  bool is_linear(int edge) const { return edge >= size() - static_cast<int>(grain_normals_.size()); }

  /// Returns the index into h of each wire part of the chart; -1 for a part without h. All sides of an elastic seam
  /// share one index.
  const std::vector<int>& elastic_of_part() const { return elastic_of_part_; }
  int num_elastic() const { return static_cast<int>(tolerance_.size()); }

  /// Returns the tolerances ε, one per entry of h.
  const Eigen::VectorXd& tolerance() const { return tolerance_; }

  /// Returns whether h_w is at a bound and f falls beyond this bound. pull: decrease of f per unit of h_w.
  bool is_at_bound(int w, double h, double pull) const { return pull > 0 ? h >= tolerance_[w] : h <= -tolerance_[w]; }

  Eigen::VectorXd within_tolerance(const Eigen::VectorXd& variation) const {
    return variation.cwiseMax(-tolerance_).cwiseMin(tolerance_);
  }

  /// Returns the h of a layout, which may be beyond the tolerances.
  Eigen::VectorXd variation(const Positions2& uv) const;

  /// Returns T, one row per edge and one column per entry of h. An elastic edge has one nonzero entry.
  const Eigen::SparseMatrix<double>& elastic_lengths() const { return elastic_lengths_; }

  /// Returns c, one per edge, in scene units.
  Eigen::VectorXd residual(const Positions2& uv, const Eigen::VectorXd& variation) const;

  /// Returns the largest |c| / (l + 10⁻⁵ √area); infinite if a residual is not finite. The second term allows for
  /// rounding: rounded coordinates change the length of very short edges noticeably.
  double largest_error(const Eigen::VectorXd& residual) const;

  static constexpr double exact = 1e-13;  // target error of the retraction
  static constexpr double kept = 1e-10;   // error up to which a length counts as exact; the guarantee is 1e-9

  /// Returns d̂, one row per edge; zero for an edge of zero length.
  Positions2 directions(const Positions2& uv) const;

  /// Returns λ ∂²c/∂d² of an edge; zero for an edge of zero length.
  Eigen::Matrix2d curvature(int edge, const Positions2& uv, double multiplier) const;

  /// Returns J d, one per edge. directions: result of directions().
  Eigen::VectorXd apply(const Positions2& directions, const Eigen::Ref<const Positions2>& d) const;

  /// Adds Jᵀ λ to the result, which has one row per chart vertex. multipliers: λ.
  void add_transposed(const Positions2& directions, const Eigen::VectorXd& multipliers,
                      Eigen::Ref<Positions2> result) const;

 private:
  const Eigen::RowVector2d& grain_normal(int edge) const {
    return grain_normals_[edge - (size() - static_cast<int>(grain_normals_.size()))];
  }

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
