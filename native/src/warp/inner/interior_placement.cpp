// SPDX-License-Identifier: GPL-3.0-or-later
#include "warp/inner/interior_placement.h"

#include <algorithm>

#include "base/in_threads.h"
#include "surface/mesh/geometry.h"
#include "surface/mesh/project_to_principal_plane.h"
#include "warp/inner/mean_value.h"

namespace wirewarp {
namespace {

std::vector<bool> vertices_on_network(const HalfEdgeMesh& mesh, const WireNetwork& network) {
  std::vector<bool> on_network(mesh.n_vertices(), false);
  for (const WireEdge& wire_edge : network.edges) {
    const HalfedgeHandle half_edge = mesh.halfedge_handle(wire_edge.edge, 0);
    on_network[mesh.from_vertex_handle(half_edge).idx()] = true;
    on_network[mesh.to_vertex_handle(half_edge).idx()] = true;
  }
  return on_network;
}

}  // namespace

InteriorPlacement::InteriorPlacement(const Chart& chart, const WireNetwork& network, const StopToken& stop) {
  const HalfEdgeMesh& mesh = chart.mesh;
  const std::vector<bool> on_network = vertices_on_network(mesh, network);
  std::vector<int> row_of_vertex(mesh.n_vertices(), -1);
  for (const VertexHandle vertex : mesh.vertices()) {
    if (on_network[vertex.idx()]) continue;
    row_of_vertex[vertex.idx()] = static_cast<int>(interior_.size());
    interior_.push_back(vertex.idx());
  }
  if (interior_.empty()) return;

  const int rows = static_cast<int>(interior_.size());
  Matrix matrix(rows, rows);
  matrix.reserve(7 * interior_.size());
  to_network_.resize(rows, static_cast<int>(mesh.n_vertices()));
  std::vector<WeightedVertex> ring;
  for (int row = 0; row < rows; ++row) {
    const VertexHandle center(interior_[row]);
    mean_value_weights(mesh, center, ring);
    ring.push_back({center, -1.0});
    std::sort(ring.begin(), ring.end(), [](const auto& a, const auto& b) { return a.vertex < b.vertex; });
    matrix.startVec(row);
    to_network_.startVec(row);
    for (const auto& [vertex, weight] : ring) {
      if (on_network[vertex.idx()]) {
        to_network_.insertBack(row, vertex.idx()) = weight;
      } else {
        matrix.insertBack(row, row_of_vertex[vertex.idx()]) = -weight;
      }
    }
  }
  matrix.finalize();
  to_network_.finalize();
  const Positions2 positions = project_to_principal_plane(points_of(mesh)(interior_, Eigen::all));
  stop.check();
  lu_.emplace(matrix, positions, has_second_core(), stop);
}

void InteriorPlacement::place(Positions2& uv) const {
  if (!lu_) return;
  Positions2 x = to_network_ * uv;
  lu_->solve(x);
  for (Eigen::Index row = 0; row < x.rows(); ++row) uv.row(interior_[row]) = x.row(row);
}

void InteriorPlacement::pull_back(Positions2& by_uv) const {
  if (!lu_) return;
  Positions2 x(static_cast<Eigen::Index>(interior_.size()), 2);
  for (Eigen::Index row = 0; row < x.rows(); ++row) {
    x.row(row) = by_uv.row(interior_[row]);
    by_uv.row(interior_[row]).setZero();
  }
  lu_->solve_transposed(x);
  by_uv += to_network_.transpose() * x;
}

}  // namespace wirewarp
