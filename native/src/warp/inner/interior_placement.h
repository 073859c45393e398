// SPDX-License-Identifier: GPL-3.0-or-later
// Places the vertices between the wires (paper II-A, the convex-combination map of its reference [38]): every vertex
// off the wire network is the weighted mean of its neighbors, with Floater's mean-value weights of the 3D surface.
//
//   (I - W) u_interior = B u_network    W, B  weights of the neighbors off and on the network
//
// The matrix does not depend on the flat shape: it is factored once per chart and used for every flattening. Each
// wire-patch is an independent block of the matrix.
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
  /// Factors I - W. Every vertex of the chart must be connected with the network, as in a connected chart with a
  /// boundary. Throws FactorizationFailed if rounding makes a pivot zero or negative.
  InteriorPlacement(const Chart& chart, const WireNetwork& network, const StopToken& stop = {});

  /// Computes the rows of uv off the network from the rows on the network. uv: one row per chart vertex.
  void place(Positions2& uv) const;

  /// Applies the adjoint of place(): turns ∂E/∂uv for all vertices into the derivative with respect to the network's
  /// vertices alone. The rows off the network become zero.
  void pull_back(Positions2& by_uv) const;

  /// Returns the number of matrix factorizations: 1, or 0 if every vertex is on the network.
  int factorizations() const { return lu_ ? 1 : 0; }

 private:
  using Matrix = MultifrontalLu::Matrix;

  std::vector<int> interior_;         // chart vertices off the network, in the order of the matrix rows
  Matrix to_network_;                 // B, one column per chart vertex
  std::optional<MultifrontalLu> lu_;  // factors of I - W
};

}  // namespace wirewarp
