// SPDX-License-Identifier: GPL-3.0-or-later
#include "metrics/metrics.h"

#include <algorithm>
#include <cmath>

#include "mesh/geometry.h"
#include "mesh/overlap.h"
#include "metrics/arap.h"
#include "planar.h"

namespace wirewarp {
namespace {

Eigen::Vector3d position(const HalfEdgeMesh& mesh, int vertex) {
  const HalfEdgeMesh::Point& p = mesh.point(VertexHandle(vertex));
  return {p[0], p[1], p[2]};
}

void measure_faces(const Chart& chart, const Triangles& faces, const Positions2& uv, Metrics& metrics) {
  metrics.face_arap.resize(faces.rows());
  metrics.face_aspect_ratio.resize(faces.rows());
  for (int f = 0; f < faces.rows(); ++f) {
    const int a = faces(f, 0);
    const int b = faces(f, 1);
    const int c = faces(f, 2);
    const TriangleDistortion t = measure_triangle(position(chart.mesh, a), position(chart.mesh, b),
                                                  position(chart.mesh, c), uv.row(a), uv.row(b), uv.row(c));
    metrics.face_arap[f] = t.arap_energy;
    metrics.face_aspect_ratio[f] = t.aspect_ratio();
    metrics.area_3d += t.area_3d;
    metrics.area_2d += t.area_2d;
    if (!(t.area_2d > 0)) metrics.flipped_faces.push_back(chart.source_face[f]);
  }
  metrics.arap_energy = metrics.face_arap.sum() / metrics.area_3d;
}

/// E_L of Eq. (5): the edges on wires first, then the rest of the boundary.
void measure_wire_edges(const Chart& chart, const WireNetwork& network, const Positions2& uv, Metrics& metrics) {
  std::vector<const WireEdge*> edges;
  for (const WireEdge& edge : network.edges) edges.push_back(&edge);
  std::stable_partition(edges.begin(), edges.end(), [](const WireEdge* edge) { return edge->part >= 0; });

  metrics.edge_length_variation.resize(static_cast<Eigen::Index>(edges.size()));
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const HalfedgeHandle h = chart.mesh.halfedge_handle(edges[i]->edge, 0);
    const int from = chart.mesh.from_vertex_handle(h).idx();
    const int to = chart.mesh.to_vertex_handle(h).idx();
    metrics.wire_edges.push_back(source_edge(chart, h));
    metrics.edge_length_variation[static_cast<Eigen::Index>(i)] =
        std::abs(edges[i]->length - (uv.row(to) - uv.row(from)).norm()) / edges[i]->length;
  }
}

/// θ − α at every node but tails, which have no angle of their own.
void measure_angles(const Chart& chart, const WireNetwork& network, const Positions2& uv, Metrics& metrics) {
  double sum_of_squares = 0;
  int count = 0;
  for (const WireNode& node : network.nodes) {
    if (node.is_tail) continue;
    const double deviation = planar_angle(chart, network, node, uv) - node.surface_angle;
    sum_of_squares += deviation * deviation;
    metrics.angle_deviation_max = std::max(metrics.angle_deviation_max, std::abs(deviation));
    ++count;
  }
  if (count > 0) metrics.angle_deviation_rms = std::sqrt(sum_of_squares / count);
}

}  // namespace

double planar_angle(const Chart& chart, const WireNetwork& network, const WireNode& node, const Positions2& uv) {
  const HalfedgeHandle in = half_edge(chart, network, node.in);
  const HalfedgeHandle out = half_edge(chart, network, node.out);
  const Eigen::Vector2d vertex = uv.row(node.vertex.idx());
  const Eigen::Vector2d back = uv.row(chart.mesh.from_vertex_handle(in).idx()).transpose() - vertex;
  const Eigen::Vector2d ahead = uv.row(chart.mesh.to_vertex_handle(out).idx()).transpose() - vertex;
  // The sector lies to the left of both edges: counter-clockwise from the way ahead to the way back.
  const double angle = std::atan2(cross(ahead, back), ahead.dot(back));
  return angle + 2 * kPi * std::round((node.surface_angle - angle) / (2 * kPi));
}

Metrics measure_metrics(const Chart& chart, const WireNetwork& network, const Positions2& uv, const StopToken& stop) {
  Metrics metrics;
  const Triangles faces = triangles_of(chart.mesh);
  measure_faces(chart, faces, uv, metrics);
  measure_wire_edges(chart, network, uv, metrics);
  measure_angles(chart, network, uv, metrics);
  for (const int f : find_overlapping_faces(faces, faces_on_boundary(chart.mesh), uv, kRelativeOverlapDepth, stop)) {
    metrics.overlapping_faces.push_back(chart.source_face[f]);
  }
  return metrics;
}

}  // namespace wirewarp
