// SPDX-License-Identifier: GPL-3.0-or-later
// Placing the vertices between the wires (paper II-A, the convex-combination map of its [38]): every vertex off the
// wire network is the weighted mean of its neighbors, with Floater's mean-value weights of the 3D surface.
//
//   (I - W) u_interior = B u_network    W, B  the weights of neighbors off and on the network
//
// The matrix knows nothing of lengths or angles of the flat shape: it is factored once per chart, and serves every
// flattening of it. Wire-patches are independent blocks of it.
#pragma once

#include <optional>
#include <vector>

#include "base/stop_token.h"
#include "numerics/cholesky/multifrontal_lu.h"
#include "surface/charts/chart.h"
#include "surface/network/wire_network.h"
#include "wirewarp/types.h"

namespace wirewarp {

class InteriorPlacement {
 public:
  /// Factors I - W. Every vertex of the chart must be joined to the network, as in a connected chart with a boundary.
  /// Throws FactorizationFailed where rounding leaves a pivot that is not positive.
  InteriorPlacement(const Chart& chart, const WireNetwork& network, const StopToken& stop = {});

  /// Fills the rows of uv (one per chart vertex) that are not on the network from those that are.
  void place(Positions2& uv) const;

  /// The adjoint of place(): adds to the rows of network vertices what the rows off the network carry to them, so that
  /// ∂E/∂uv of all vertices becomes the derivative by the network's alone. The rows off the network become zero.
  void pull_back(Positions2& by_uv) const;

  /// Matrices factored: 1, or 0 where every vertex lies on the network.
  int factorizations() const { return lu_ ? 1 : 0; }

 private:
  using Matrix = MultifrontalLu::Matrix;

  std::vector<int> interior_;         // chart vertices off the network: row i of the matrices is vertex interior_[i]
  Matrix to_network_;                 // B, with a column per chart vertex
  std::optional<MultifrontalLu> lu_;  // of I - W
};

}  // namespace wirewarp
