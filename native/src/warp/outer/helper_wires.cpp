// SPDX-License-Identifier: GPL-3.0-or-later
#include "warp/outer/helper_wires.h"

#include <utility>

#include "surface/mesh/geometry.h"

namespace wirewarp {

std::vector<PlacedHelperWire> list_helper_wires(const Chart& prepared, std::size_t first_part,
                                                const Eigen::VectorXd& variation) {
  const HalfEdgeMesh& mesh = prepared.mesh;
  std::vector<PlacedHelperWire> helpers;
  for (std::size_t part = first_part; part < prepared.wire_parts.size(); ++part) {
    const HalfEdgeChain& chain = prepared.wire_parts[part].half_edges;
    PlacedHelperWire helper;
    for (const VertexHandle v : vertices_along(mesh, chain)) helper.vertices.push_back(v.idx());
    helper.wire.length_3d = length_of(mesh, chain);
    helper.wire.points_3d.resize(static_cast<Eigen::Index>(helper.vertices.size()), 3);
    for (int k = 0; k < helper.wire.points_3d.rows(); ++k) {
      const auto point = mesh.point(VertexHandle(helper.vertices[k]));
      helper.wire.points_3d.row(k) << point[0], point[1], point[2];
    }
    helper.wire.variation = variation[static_cast<Eigen::Index>(part)];
    helper.wire.length_2d = (1 + helper.wire.variation) * helper.wire.length_3d;
    helpers.push_back(std::move(helper));
  }
  return helpers;
}

std::vector<HelperWire> place_helper_wires(std::vector<PlacedHelperWire> helpers, const Positions2& uv) {
  std::vector<HelperWire> wires;
  for (PlacedHelperWire& helper : helpers) {
    helper.wire.points_2d = uv(helper.vertices, Eigen::all);
    wires.push_back(std::move(helper.wire));
  }
  return wires;
}

}  // namespace wirewarp
