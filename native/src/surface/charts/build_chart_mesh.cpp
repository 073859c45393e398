// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/charts/build_chart_mesh.h"

#include <algorithm>
#include <tuple>

#include "base/planar.h"
#include "surface/charts/slits.h"
#include "surface/mesh/geometry.h"

namespace wirewarp {
namespace {

/// Adds one chart vertex per fan of corners, in the order of the input's vertices.
void add_vertices(const FlattenInput& input, const SurfaceCut& cut, Chart& chart, ChartHandles& handles) {
  struct Fan {
    int vertex, fan;
  };
  std::vector<Fan> fans;
  fans.reserve(chart.source_face.size() / 2 + 2);
  for (const int f : chart.source_face) {
    for (int k = 0; k < 3; ++k) {
      const int fan = cut.fan_of_corner[3 * f + k];
      VertexHandle& v = handles.vertex_of_fan[fan];
      if (v.is_valid()) continue;
      v = VertexHandle(0);  // marks the fan as used, until its vertex is added below
      fans.push_back({input.faces(f, k), fan});
    }
  }
  std::sort(fans.begin(), fans.end(),
            [](const Fan& a, const Fan& b) { return std::tie(a.vertex, a.fan) < std::tie(b.vertex, b.fan); });
  for (const Fan& fan : fans) {
    const auto p = input.vertices.row(fan.vertex);
    handles.vertex_of_fan[fan.fan] = chart.mesh.add_vertex({p[0], p[1], p[2]});
    chart.source_vertex.push_back(fan.vertex);
  }
}

/// Adds edges and faces without OpenMesh's add_face(). The sides of edges are matched already, so the order of faces
/// does not affect the result.
void add_faces(const EdgeTable& edges, const SurfaceCut& cut, Chart& chart, ChartHandles& handles) {
  HalfEdgeMesh& mesh = chart.mesh;
  const auto vertex_of_corner = [&](int corner) { return handles.vertex_of_fan[cut.fan_of_corner[corner]]; };
  for (const int f : chart.source_face) {
    const FaceHandle face = mesh.new_face();
    std::array<HalfedgeHandle, 3> loop;
    for (int k = 0; k < 3; ++k) {
      const int side = 3 * f + k;
      HalfedgeHandle& h = handles.half_edge_of_side[side];
      if (!h.is_valid()) {
        h = mesh.new_edge(vertex_of_corner(side), vertex_of_corner(3 * f + (k + 1) % 3));
        const int edge = edges.edge_of_side(side);
        if (!cut.is_outline(edges, edge)) {
          const int mate = edges.side(edge, edges.side(edge, 0) == side ? 1 : 0);
          handles.half_edge_of_side[mate] = mesh.opposite_halfedge_handle(h);
        }
      }
      loop[k] = h;
      mesh.set_face_handle(h, face);
      mesh.set_halfedge_handle(mesh.from_vertex_handle(h), h);
    }
    for (int k = 0; k < 3; ++k) mesh.set_next_halfedge_handle(loop[k], loop[(k + 1) % 3]);
    mesh.set_halfedge_handle(face, loop[0]);
  }
}

/// Links the half-edges without a face, and returns them. At a boundary vertex, the outgoing boundary half-edge comes
/// first, as OpenMesh requires.
std::vector<HalfedgeHandle> link_boundary(HalfEdgeMesh& mesh) {
  std::vector<HalfedgeHandle> boundary;
  for (const HalfedgeHandle h : mesh.halfedges()) {
    if (!mesh.is_boundary(h)) continue;
    boundary.push_back(h);
    mesh.set_halfedge_handle(mesh.from_vertex_handle(h), h);
  }
  for (const HalfedgeHandle h : boundary) {
    mesh.set_next_halfedge_handle(h, mesh.halfedge_handle(mesh.to_vertex_handle(h)));
  }
  return boundary;
}

/// Returns the sum of pi - surface angle along a boundary loop: 2 pi for the outer loop of a flat chart, -2 pi for a
/// hole.
double total_turning(const HalfEdgeMesh& mesh, const HalfEdgeChain& loop) {
  double turning = 0;
  for (const HalfedgeHandle h : loop) turning += kPi - total_angle(mesh, mesh.from_vertex_handle(h));
  return turning;
}

/// Returns the index of the loop that turns most to the left; of equal loops, the longest. On a rough surface, a slit
/// may turn most, so it counts only if all loops are slits.
std::size_t find_outer_loop(const Chart& chart, const std::vector<HalfEdgeChain>& loops) {
  constexpr double kSameTurning = 1e-6;  // radians: far above rounding, far below any intended turn
  std::size_t outer = 0;
  bool outer_is_slit = true;
  double outer_turning = -1e300;
  double outer_length = 0;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const bool is_slit = as_slit(chart, loops[i]).has_value();
    const double turning = total_turning(chart.mesh, loops[i]);
    const double length = length_of(chart.mesh, loops[i]);
    const bool turns_alike = std::abs(turning - outer_turning) < kSameTurning;
    const bool turns_more = turns_alike ? length > outer_length : turning > outer_turning;
    if (is_slit == outer_is_slit ? turns_more : outer_is_slit) {
      outer = i;
      outer_is_slit = is_slit;
      outer_turning = turning;
      outer_length = length;
    }
  }
  return outer;
}

std::vector<HalfEdgeChain> find_boundary_loops(const Chart& chart, const std::vector<HalfedgeHandle>& boundary) {
  const HalfEdgeMesh& mesh = chart.mesh;
  std::vector<HalfEdgeChain> loops;
  std::vector<char> is_seen(mesh.n_halfedges(), 0);
  for (const HalfedgeHandle start : boundary) {
    if (is_seen[start.idx()]) continue;
    HalfEdgeChain loop;
    for (HalfedgeHandle h = start; !is_seen[h.idx()]; h = mesh.next_halfedge_handle(h)) {
      is_seen[h.idx()] = 1;
      loop.push_back(mesh.opposite_halfedge_handle(h));
    }
    std::reverse(loop.begin(), loop.end());
    loops.push_back(std::move(loop));
  }
  if (loops.size() > 1) std::swap(loops[0], loops[find_outer_loop(chart, loops)]);
  return loops;
}

}  // namespace

void build_chart_mesh(const FlattenInput& input, const EdgeTable& edges, const SurfaceCut& cut, Chart& chart,
                      ChartHandles& handles) {
  const std::size_t num_faces = chart.source_face.size();
  chart.mesh.reserve(num_faces / 2 + 2, 3 * num_faces / 2 + 3, num_faces);
  add_vertices(input, cut, chart, handles);
  add_faces(edges, cut, chart, handles);
  chart.boundary_loops = find_boundary_loops(chart, link_boundary(chart.mesh));
}

}  // namespace wirewarp
