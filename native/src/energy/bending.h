// SPDX-License-Identifier: GPL-3.0-or-later
// The fairness of wires: how far the corners of the flat wire network are from those of the surface.
//
//   node  a → b → c, the surface on its left; α its surface angle, l the lengths asked for, ℓ their mean
//   r     = (u_c − u_b) / l_bc − R(π − α) (u_b − u_a) / l_ab
//   F(u)  = ½ Σ w |r|²,  w about D³/ℓ as shown below,  D = fairness · √area
//
// With exact lengths |r|² = 2 − 2 cos(θ − α), the angle term of Eq. (1) for small deviations, and yet F is quadratic in
// the positions with a constant matrix. D is the shortest wiggle that is left to itself: without F rigid boundaries
// buckle into zigzags.
//
// Along a line (a wire or a boundary loop) the deviation shrinks with ℓ, and the sum becomes an integral as the mesh is
// refined. The angle at which two lines meet deviates by the same on every mesh: 1/ℓ would hold it the more the finer
// the mesh, and make the piece worse. A corner between lines weighs no more than one with edges of D/8; a line that
// passes k corners on a side is held by what more k equal shares of its deviation would weigh,
//
//   corner   w = D³ / max(ℓ, D/8)
//   line     w = (D³/ℓ − D³ / max(ℓ, D/8)) / k,  D³/ℓ where it passes none,  ℓ the mean of its corners
//
// so that edges no shorter than D/8 have the weight D³/ℓ at every corner and no other.
#pragma once

#include <vector>

#include "energy/vertex_matrix.h"
#include "surface/network/wire_network.h"

namespace wirewarp {

class Bending {
 public:
  /// network: of the edges whose length is held. Where a wire ends inside there is no node. area_at: per vertex, the 3D
  /// area of the connected surface it lies on.
  Bending(const Chart& chart, const WireNetwork& network, double fairness, const std::vector<double>& area_at);

  /// F, and adds ∂F/∂u to the gradient. uv, gradient: one row per chart vertex.
  double value(const Positions2& uv) const;
  double add_gradient(const Positions2& uv, Positions2& gradient) const;

  /// F of an isometric layout once all coordinates are off by about error.
  double value_of_rounding(double error) const;

  /// The vertices that its Hessian couples.
  void list_pairs(std::vector<VertexPair>& pairs) const;

  /// Adds the Hessian, constant and positive semidefinite.
  void add_hessian(VertexMatrix& hessian) const;

 private:
  /// r = to_a u_a + to_b u_b + to_c u_c. Never through the Hessian: short edges make its entries 1e8 times those of F.
  struct Node {
    int a, b, c;
    double weight;
    Eigen::Matrix2d to_a, to_b, to_c;

    Eigen::Vector2d residual(const Positions2& uv) const;
  };
  std::vector<Node> nodes_;
};

}  // namespace wirewarp
