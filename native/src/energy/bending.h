// SPDX-License-Identifier: GPL-3.0-or-later
// The fairness F of wires penalizes the difference between the angles of the flat wire network and of the surface.
//
//   node  a → b → c, the surface on its left; α: surface angle at b, θ: flat angle at b
//         l: target lengths, ℓ: mean of l_ab and l_bc
//   r     = (u_c − u_b) / l_bc − R(π − α) (u_b − u_a) / l_ab
//   F(u)  = ½ Σ w |r|²,  w about D³/ℓ as shown below,  D = fairness · √area
//
// With exact lengths, |r|² = 2 − 2 cos(θ − α), which is the angle term of Eq. (1) for small deviations. F is quadratic
// in the positions, with a constant matrix. Without F, rigid boundaries buckle into zigzags. F hardly penalizes waves
// longer than D.
//
// Along a line (a wire or a boundary loop), the deviation θ − α is proportional to ℓ. With the weight D³/ℓ, the sum
// becomes an integral as the mesh is refined. At a corner between two lines, the deviation does not depend on the mesh.
// With the weight D³/ℓ, finer meshes would constrain this corner more and make the piece worse. Therefore the weight of
// a corner is at most its value for edges of length D/8. If a line passes k corners on one side, it gets the rest of
// the weight:
//
//   corner   w = D³ / max(ℓ, D/8)
//   line     w = (D³/ℓ − D³ / max(ℓ, D/8)) / k,  ℓ: mean over these corners;  D³/ℓ if there are no corners
//
// If all edges are at least D/8 long, every corner has weight D³/ℓ, and a line has weight 0 where it passes corners.
#pragma once

#include <vector>

#include "energy/quadratic_form.h"
#include "surface/network/wire_network.h"

namespace wirewarp {

/// The vertices of a term are b, a, c in this order, because only the last two vertices of a QuadraticForm's term may
/// have no common face.
using Bending = QuadraticForm<Eigen::Matrix2d, 3>;

/// Returns F, without terms where wires end inside the chart.
/// network: the edges with fixed length. area_at: for each vertex, the 3D area of its connected part.
Bending bending_of(const Chart& chart, const WireNetwork& network, double fairness, const std::vector<double>& area_at);

}  // namespace wirewarp
