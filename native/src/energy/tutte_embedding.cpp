// SPDX-License-Identifier: GPL-3.0-or-later
#include "energy/tutte_embedding.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/factorization_failed.h"
#include "base/in_threads.h"
#include "base/planar.h"
#include "numerics/cholesky/matrix_graph.h"
#include "numerics/cholesky/multifrontal_cholesky.h"
#include "surface/mesh/geometry.h"
#include "surface/mesh/project_to_principal_plane.h"

namespace wirewarp {
namespace {

void put_on_circle(const HalfEdgeMesh& mesh, const HalfEdgeChain& loop, double radius, Positions2& uv) {
  const double radians = 2 * kPi / length_of(mesh, loop);
  double along = 0;
  for (const HalfedgeHandle h : loop) {
    uv.row(mesh.from_vertex_handle(h).idx()) << radius * std::cos(radians * along), radius * std::sin(radians * along);
    along += edge_length(mesh, h);
  }
}

/// Springs between points. The points are the chart's vertices, then the apexes of the cones. Points on the outer loop
/// are fixed at their uv.
class Springs {
 public:
  Springs(const HalfEdgeMesh& mesh, const HalfEdgeChain& fixed_loop, std::size_t num_apexes, Positions2& uv)
      : uv_(uv), row_of_point_(mesh.n_vertices() + num_apexes, 0) {
    for (const HalfedgeHandle h : fixed_loop) row_of_point_[mesh.from_vertex_handle(h).idx()] = -1;
    int num_rows = 0;
    for (int& row : row_of_point_) {
      if (row == 0) row = num_rows++;
    }
    entries_.reserve(9 * mesh.n_faces());
    x_.setZero(num_rows, 2);
  }

  void join(int a, int b, double stiffness) {
    add_force(a, b, stiffness);
    add_force(b, a, stiffness);
    const auto [column, row] = std::minmax(row_of_point_[a], row_of_point_[b]);
    if (column >= 0) entries_.emplace_back(row, column, -stiffness);
  }

  /// Moves the free points to their equilibrium. layout: any positions in which neighboring points are near each other;
  /// determines the elimination order.
  void relax(const Positions2& layout, const StopToken& stop) {
    if (x_.rows() == 0) return;
    Eigen::SparseMatrix<double> stiffness(x_.rows(), x_.rows());
    stiffness.setFromTriplets(entries_.begin(), entries_.end());
    Positions2 free_layout(x_.rows(), 2);
    for (Eigen::Index p = 0; p < layout.rows(); ++p) {
      if (row_of_point_[p] >= 0) free_layout.row(row_of_point_[p]) = layout.row(p);
    }
    MultifrontalCholesky cholesky(stiffness, nested_dissection(graph_of(stiffness, 1), free_layout), 1,
                                  has_second_core());
    stop.check();
    const bool is_stable = cholesky.factorize(stiffness, stop);
    if (stop.is_stopped()) throw Stopped();
    if (!is_stable) throw FactorizationFailed("tutte_embedding: the springs are not stable");
    cholesky.solve_in_place(x_);
    for (Eigen::Index v = 0; v < uv_.rows(); ++v) {
      if (row_of_point_[v] >= 0) uv_.row(v) = x_.row(row_of_point_[v]);
    }
  }

 private:
  void add_force(int point, int end, double stiffness) {
    const int row = row_of_point_[point];
    if (row < 0) return;
    entries_.emplace_back(row, row, stiffness);
    if (row_of_point_[end] < 0) x_.row(row) += stiffness * uv_.row(end);
  }

  Positions2& uv_;
  std::vector<int> row_of_point_;  // -1: fixed
  std::vector<Eigen::Triplet<double>> entries_;
  Eigen::MatrixX2d x_;  // first the right-hand side, then the positions of the free points
};

/// Each corner with the angle α adds tan(α/2)/l to the stiffness of each of its two edges. l is the length of the edge.
void add_faces(const HalfEdgeMesh& mesh, Springs& springs) {
  for (const HalfedgeHandle h : mesh.halfedges()) {
    if (mesh.is_boundary(h)) continue;
    const HalfedgeHandle back = mesh.prev_halfedge_handle(h);
    const int corner = mesh.from_vertex_handle(h).idx();
    const double tan_half = std::tan(corner_angle(mesh, h) / 2);
    springs.join(corner, mesh.to_vertex_handle(h).idx(), tan_half / edge_length(mesh, h));
    springs.join(corner, mesh.from_vertex_handle(back).idx(), tan_half / edge_length(mesh, back));
  }
}

/// Adds a cone over a hole, as if the hole were a circle around the apex. Corners at the loop count as right angles.
/// For a corner with the angle α at the apex, tan(α/2) counts as length / (2 radius).
void add_cone(const HalfEdgeMesh& mesh, const HalfEdgeChain& hole, int apex, Springs& springs) {
  const double radius = length_of(mesh, hole) / (2 * kPi);
  for (const HalfedgeHandle h : hole) {
    const int a = mesh.from_vertex_handle(h).idx(), b = mesh.to_vertex_handle(h).idx();
    const double length = edge_length(mesh, h);
    springs.join(a, b, 2 / length);
    for (const int end : {a, b}) springs.join(end, apex, (1 + length / (2 * radius)) / radius);
  }
}

Eigen::RowVector2d middle_of(const HalfEdgeMesh& mesh, const HalfEdgeChain& loop, const Positions2& layout) {
  Eigen::RowVector2d sum = Eigen::RowVector2d::Zero();
  for (const HalfedgeHandle h : loop) sum += layout.row(mesh.from_vertex_handle(h).idx());
  return sum / static_cast<double>(loop.size());
}

}  // namespace

Positions2 tutte_embedding(const Chart& chart, const StopToken& stop) {
  const HalfEdgeMesh& mesh = chart.mesh;
  const auto num_vertices = static_cast<int>(mesh.n_vertices());
  Positions2 uv(num_vertices, 2);
  put_on_circle(mesh, chart.boundary_loops.front(), std::sqrt(surface_area(mesh) / kPi), uv);

  const std::size_t num_holes = chart.boundary_loops.size() - 1;
  Springs springs(mesh, chart.boundary_loops.front(), num_holes, uv);
  Positions2 layout = project_to_principal_plane(points_of(mesh));
  layout.conservativeResize(num_vertices + static_cast<Eigen::Index>(num_holes), 2);
  add_faces(mesh, springs);
  for (std::size_t hole = 0; hole < num_holes; ++hole) {
    const int apex = num_vertices + static_cast<int>(hole);
    add_cone(mesh, chart.boundary_loops[hole + 1], apex, springs);
    layout.row(apex) = middle_of(mesh, chart.boundary_loops[hole + 1], layout);
  }
  springs.relax(layout, stop);
  return uv;
}

}  // namespace wirewarp
