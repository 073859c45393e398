// SPDX-License-Identifier: GPL-3.0-or-later
// The fairness term of wires: the difference between the corner angles of the flat wire network and of the surface.
//
//   node  a → b → c, the surface on its left; α its surface angle, l the target lengths, ℓ their mean
//   r     = (u_c − u_b) / l_bc − R(π − α) (u_b − u_a) / l_ab
//   F(u)  = ½ Σ w |r|²,  w about D³/ℓ as shown below,  D = fairness · √area
//
// With exact lengths, |r|² = 2 − 2 cos(θ − α), which is the angle term of Eq. (1) for small deviations. F is quadratic
// in the positions, with a constant matrix. Without F, rigid boundaries buckle into zigzags; F hardly penalizes waves
// longer than D.
//
// Along a line (a wire or a boundary loop), the deviation is proportional to ℓ, and the sum becomes an integral as the
// mesh is refined. But the angle between two lines that meet deviates equally on every mesh: a weight proportional to
// 1/ℓ would constrain it more on finer meshes and make the piece worse. Therefore a corner between lines has at most
// the weight of a corner with edges of length D/8. The rest of the weight acts on the line itself, divided by k, the
// number of corners on this side of the line:
//
//   corner   w = D³ / max(ℓ, D/8)
//   line     w = (D³/ℓ − D³ / max(ℓ, D/8)) / k,  D³/ℓ where it passes none,  ℓ the mean of its corners
//
// If all edges are at least D/8 long, every corner has weight D³/ℓ and the lines have weight 0.
#pragma once

#include <vector>

#include "energy/vertex_matrix.h"
#include "surface/network/wire_network.h"

namespace wirewarp {

class Bending {
 public:
  /// network: the edges with fixed length. There is no node where a wire ends inside the chart. area_at: per vertex,
  /// the 3D area of its connected surface.
  Bending(const Chart& chart, const WireNetwork& network, double fairness, const std::vector<double>& area_at);

  /// Returns F; add_gradient() also adds ∂F/∂u to the gradient. uv, gradient: one row per chart vertex.
  double value(const Positions2& uv) const;
  double add_gradient(const Positions2& uv, Positions2& gradient) const;

  /// Returns F of an isometric layout if all coordinates have errors of about `error`.
  double value_of_rounding(double error) const;

  /// Appends the pairs of vertices that the Hessian couples.
  void list_pairs(std::vector<VertexPair>& pairs) const;

  /// Adds the Hessian, constant and positive semidefinite.
  void add_hessian(VertexMatrix& hessian) const;

 private:
  /// r = to_a u_a + to_b u_b + to_c u_c. F is computed from r, not from the Hessian, because short edges make entries
  /// of the Hessian 1e8 times as large as F.
  struct Node {
    int a, b, c;
    double weight;
    Eigen::Matrix2d to_a, to_b, to_c;

    Eigen::Vector2d residual(const Positions2& uv) const;
  };
  std::vector<Node> nodes_;
};

}  // namespace wirewarp
