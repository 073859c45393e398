// SPDX-License-Identifier: GPL-3.0-or-later
// The fairness term of wires: the difference between the corner angles of the flat wire network and of the surface.
//
//   node  a → b → c, the surface on its left; α: surface angle at b, l: target lengths, ℓ: mean of l_ab and l_bc
//   r     = (u_c − u_b) / l_bc − R(π − α) (u_b − u_a) / l_ab
//   F(u)  = ½ Σ w |r|²,  w about D³/ℓ as shown below,  D = fairness · √area
//
// With exact lengths, |r|² = 2 − 2 cos(θ − α), which is the angle term of Eq. (1) for small deviations. F is quadratic
// in the positions, with a constant matrix. Without F, rigid boundaries buckle into zigzags; F hardly penalizes waves
// longer than D.
//
// Along a line (a wire or a boundary loop), the deviation is proportional to ℓ, and the sum becomes an integral as the
// mesh is refined. But the angle between two lines that meet deviates equally on every mesh. A weight proportional to
// 1/ℓ would constrain this angle more on finer meshes, and make the piece worse. Therefore a corner between lines has
// at most the weight of a corner with edges of length D/8. The rest of the weight acts on the line itself, divided by
// k, the number of corners on this side of the line:
//
//   corner   w = D³ / max(ℓ, D/8)
//   line     w = (D³/ℓ − D³ / max(ℓ, D/8)) / k,  ℓ: mean over these corners;  D³/ℓ if there are no corners
//
// If all edges are at least D/8 long, every corner has weight D³/ℓ and the lines have weight 0.
#pragma once

#include <vector>

#include "energy/quadratic_form.h"
#include "surface/network/wire_network.h"

namespace wirewarp {

/// F with the terms a → b → c. b is the first vertex of a term, because only a and c may have no common face.
using Bending = QuadraticForm<Eigen::Matrix2d, 3>;

/// Returns F. A wire has no term where it ends inside the chart. network: the edges with fixed length. area_at: for
/// each vertex, the 3D area of its connected part.
Bending bending_of(const Chart& chart, const WireNetwork& network, double fairness, const std::vector<double>& area_at);

}  // namespace wirewarp
