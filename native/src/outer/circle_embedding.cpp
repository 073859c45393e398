// SPDX-License-Identifier: GPL-3.0-or-later
#include "outer/circle_embedding.h"

#include <cmath>
#include <vector>

#include "inner/sparse_lu.h"
#include "mesh/geometry.h"
#include "pi.h"

namespace wirewarp {
namespace {

double length_of(const HalfEdgeMesh& mesh, const HalfEdgeChain& loop) {
  double length = 0;
  for (const HalfedgeHandle h : loop) length += edge_length(mesh, h);
  return length;
}

double area_of(const HalfEdgeMesh& mesh) {
  double area = 0;
  for (const FaceHandle face : mesh.faces()) {
    const HalfedgeHandle h = mesh.halfedge_handle(face), next = mesh.next_halfedge_handle(h);
    const auto& corner = mesh.point(mesh.to_vertex_handle(h));
    const auto along = mesh.point(mesh.to_vertex_handle(next)) - corner;
    const auto back = mesh.point(mesh.from_vertex_handle(h)) - corner;
    area += (along % back).norm() / 2;
  }
  return area;
}

void put_on_circle(const HalfEdgeMesh& mesh, const HalfEdgeChain& loop, double radius, Positions2& uv) {
  const double radians = 2 * kPi / length_of(mesh, loop);
  double along = 0;
  for (const HalfedgeHandle h : loop) {
    uv.row(mesh.from_vertex_handle(h).idx()) << radius * std::cos(radians * along), radius * std::sin(radians * along);
    along += edge_length(mesh, h);
  }
}

/// The system that puts every free point at the weighted mean of its neighbors. Points are the chart's vertices, then
/// the apexes; those on a loop are fixed where uv has them.
class MeanOfNeighbors {
 public:
  MeanOfNeighbors(const HalfEdgeMesh& mesh, const HalfEdgeChain& fixed_loop, std::size_t num_apexes, Positions2& uv)
      : uv_(uv), row_of_point_(mesh.n_vertices() + num_apexes, 0) {
    for (const HalfedgeHandle h : fixed_loop) row_of_point_[mesh.from_vertex_handle(h).idx()] = -1;
    int num_rows = 0;
    for (int& row : row_of_point_) {
      if (row == 0) row = num_rows++;
    }
    entries_.reserve(12 * mesh.n_faces());
    x_.setZero(num_rows, 2);
  }

  void add_weight(int point, int neighbor, double weight) {
    const int row = row_of_point_[point], column = row_of_point_[neighbor];
    if (row < 0) return;
    entries_.emplace_back(row, row, weight);
    if (column >= 0) {
      entries_.emplace_back(row, column, -weight);
    } else {
      x_.row(row) += weight * uv_.row(neighbor);
    }
  }

  void solve() {
    if (x_.rows() == 0) return;
    SparseLu::Matrix matrix(x_.rows(), x_.rows());
    matrix.setFromTriplets(entries_.begin(), entries_.end());
    SparseLu(matrix).solve(x_);
    for (Eigen::Index v = 0; v < uv_.rows(); ++v) {
      if (row_of_point_[v] >= 0) uv_.row(v) = x_.row(row_of_point_[v]);
    }
  }

 private:
  Positions2& uv_;
  std::vector<int> row_of_point_;  // -1 where fixed
  std::vector<Eigen::Triplet<double>> entries_;
  Positions2 x_;  // the right-hand side, then the free points
};

/// tan(α/2)/l at every corner, to both its edges.
void add_faces(const HalfEdgeMesh& mesh, MeanOfNeighbors& system) {
  for (const HalfedgeHandle h : mesh.halfedges()) {
    if (mesh.is_boundary(h)) continue;
    const HalfedgeHandle back = mesh.prev_halfedge_handle(h);
    const int corner = mesh.from_vertex_handle(h).idx();
    const double tan_half = std::tan(corner_angle(mesh, h) / 2);
    system.add_weight(corner, mesh.to_vertex_handle(h).idx(), tan_half / edge_length(mesh, h));
    system.add_weight(corner, mesh.from_vertex_handle(back).idx(), tan_half / edge_length(mesh, back));
  }
}

/// The cone over a hole, as steep as makes it meet the loop at right angles: radius r = loop length / 2π, weights
/// tan(π/4) = 1 over the distance. Only their proportions count at the apex.
void add_cone(const HalfEdgeMesh& mesh, const HalfEdgeChain& hole, int apex, MeanOfNeighbors& system) {
  const double radius = length_of(mesh, hole) / (2 * kPi);
  for (const HalfedgeHandle h : hole) {
    const int a = mesh.from_vertex_handle(h).idx(), b = mesh.to_vertex_handle(h).idx();
    const double length = edge_length(mesh, h);
    system.add_weight(a, b, 1 / length);
    system.add_weight(b, a, 1 / length);
    for (const int end : {a, b}) {
      system.add_weight(end, apex, 1 / radius);
      system.add_weight(apex, end, length);
    }
  }
}

}  // namespace

Positions2 embed_on_circle(const Chart& chart) {
  const HalfEdgeMesh& mesh = chart.mesh;
  const auto num_vertices = static_cast<int>(mesh.n_vertices());
  Positions2 uv(num_vertices, 2);
  put_on_circle(mesh, chart.boundary_loops.front(), std::sqrt(area_of(mesh) / kPi), uv);

  const std::size_t num_holes = chart.boundary_loops.size() - 1;
  MeanOfNeighbors system(mesh, chart.boundary_loops.front(), num_holes, uv);
  add_faces(mesh, system);
  for (std::size_t hole = 0; hole < num_holes; ++hole) {
    add_cone(mesh, chart.boundary_loops[hole + 1], num_vertices + static_cast<int>(hole), system);
  }
  system.solve();
  return uv;
}

}  // namespace wirewarp
