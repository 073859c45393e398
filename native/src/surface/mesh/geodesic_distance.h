// SPDX-License-Identifier: GPL-3.0-or-later
// Distances along a surface by the heat method (K. Crane, C. Weischedel, M. Wardetzky, Geodesics in heat, ACM
// Transactions on Graphics 32, 2013): for a short time, heat flows from a vertex in the directions of the shortest
// paths. The distance is the function whose gradient has these directions and length 1.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "base/stop_token.h"
#include "numerics/cholesky/multifrontal_cholesky.h"
#include "surface/mesh/half_edge_mesh.h"

namespace wirewarp {

class GeodesicDistance {
 public:
  /// mesh: connected; must outlive the object. Throws Stopped.
  GeodesicDistance(const HalfEdgeMesh& mesh, const StopToken& stop);

  /// Returns the distance of each vertex from the source, scene units.
  Eigen::VectorXd from(VertexHandle source) const;

 private:
  const HalfEdgeMesh& mesh_;
  std::vector<double> cotangents_;  // per half-edge: cotangent of the opposite angle; 0 on a boundary
  /// Factors of M + t L, and of L with a small multiple of M. M: areas at vertices, L: Laplacian, t: time of the flow.
  std::unique_ptr<MultifrontalCholesky> heat_, poisson_;
};

}  // namespace wirewarp
