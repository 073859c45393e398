// SPDX-License-Identifier: GPL-3.0-or-later
// A penalty on shear that zigzags from triangle to triangle. A thread that is compressed by more than shear/(shear +
// weft), a few percent for a woven fabric, can shorten further by zigzagging at the cost of a little shear. The energy
// of a fabric is not convex then, and its minima become rougher with every refinement of the mesh. Real threads resist
// by their bending stiffness; here, the jump of the map's derivative across an edge costs
//
//   Z(u) = ½ (δ √A)² Σ (l/d) |[∂u/∂ν]|²    over the inner edges
//
// with [∂u/∂ν] the jump of the derivative across the edge, l its length, d the distance of the centroids of its
// unfolded triangles, A the area of the connected part. It is the interior penalty of discontinuous Galerkin methods on
// plates (J. Douglas, T. Dupont, Interior penalty procedures, 1976): quadratic, independent of refinement, and zero
// where the chart is unfolded.
#pragma once

#include <array>
#include <vector>

#include "energy/vertex_matrix.h"
#include "surface/charts/chart.h"

namespace wirewarp {

class ShearSmoothing {
 public:
  explicit ShearSmoothing(const Chart& chart);

  /// Returns Z; add_gradient() also adds ∂Z/∂u to the gradient. uv, gradient: one row per chart vertex.
  double value(const Positions2& uv) const;
  double add_gradient(const Positions2& uv, Positions2& gradient) const;

  /// Returns Z of an isometric layout if all coordinates have errors of about `error`.
  double value_of_rounding(double error) const;

  /// Appends the pairs of vertices that the Hessian couples.
  void list_pairs(std::vector<VertexPair>& pairs) const;

  /// Adds the Hessian, constant and positive semidefinite.
  void add_hessian(VertexMatrix& hessian) const;

 private:
  /// The jump is Σ share_k u_k over the ends of the edge and the two vertices opposite to it.
  struct Edge {
    std::array<int, 4> vertices;
    std::array<double, 4> shares;
    double weight;

    Eigen::RowVector2d jump(const Positions2& uv) const;
  };
  std::vector<Edge> edges_;
};

}  // namespace wirewarp
