// SPDX-License-Identifier: GPL-3.0-or-later
// Against shear that zigzags from triangle to triangle. A thread that is squeezed by more than shear/(shear + weft), a
// few percent of a woven, is shorter still once it zigzags, at the price of a little shear: the energy of a cloth is
// not convex there, and its minima get rougher with every refinement. What a cloth has against that is that its threads
// are stiff: a fold in the map costs
//
//   Z(u) = ½ (δ √A)² Σ (l/d) |[∂u/∂ν]|²    over the inner edges
//
// with [∂u/∂ν] the jump of the derivative across the edge, l its length, d the distance of the centroids of its
// triangles, laid flat, A the area of the connected part. It is the interior penalty of discontinuous Galerkin methods
// on plates (J. Douglas, T. Dupont, Interior penalty procedures, 1976): quadratic, the same for every refinement, zero
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

  /// Z, and adds ∂Z/∂u to the gradient. uv, gradient: one row per chart vertex.
  double value(const Positions2& uv) const;
  double add_gradient(const Positions2& uv, Positions2& gradient) const;

  /// Z of an isometric layout once all coordinates are off by about error.
  double value_of_rounding(double error) const;

  /// The vertices that its Hessian couples.
  void list_pairs(std::vector<VertexPair>& pairs) const;

  /// Adds the Hessian, constant and positive semidefinite.
  void add_hessian(VertexMatrix& hessian) const;

 private:
  /// The jump is Σ share_k u_k, over the ends of the edge and the two vertices opposite to it.
  struct Edge {
    std::array<int, 4> vertices;
    std::array<double, 4> shares;
    double weight;

    Eigen::RowVector2d jump(const Positions2& uv) const;
  };
  std::vector<Edge> edges_;
};

}  // namespace wirewarp
