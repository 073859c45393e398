// SPDX-License-Identifier: GPL-3.0-or-later
#include "result/metrics.h"

#include <algorithm>
#include <cmath>

#include "base/planar.h"
#include "base/sentence.h"
#include "energy/cloth_law.h"
#include "energy/shape_error.h"
#include "surface/mesh/geometry.h"
#include "surface/mesh/overlap.h"
#include "surface/mesh/widespread.h"

namespace wirewarp {
namespace {

void measure_faces(const Chart& chart, const Positions2& uv, Metrics& metrics) {
  const ShapeError shape_error(chart);
  const auto num_faces = static_cast<Eigen::Index>(shape_error.triangles().size());
  metrics.face_arap.resize(num_faces);
  metrics.face_aspect_ratio.resize(num_faces);
  metrics.face_weft_strain.resize(num_faces);
  metrics.face_warp_strain.resize(num_faces);
  metrics.face_shear_angle.resize(num_faces);
  for (Eigen::Index f = 0; f < num_faces; ++f) {
    const ShapeError::Triangle& triangle = shape_error.triangles()[static_cast<std::size_t>(f)];
    const ShapeError::LinearMap map = ShapeError::map_of(triangle, uv);
    const Eigen::Vector2d a = uv.row(triangle.vertices[0]), b = uv.row(triangle.vertices[1]),
                          c = uv.row(triangle.vertices[2]);
    const double area_2d = cross(b - a, c - a) / 2;
    metrics.face_arap[f] = triangle.area * map.squared_distance_from_rotation();
    metrics.face_aspect_ratio[f] = map.worst_stretch();
    const ClothLaw::Invariants threads(map.matrix());
    const double size = std::abs(threads.determinant);
    metrics.face_weft_strain[f] = threads.p / size - 1;
    metrics.face_warp_strain[f] = threads.q / size - 1;
    metrics.face_shear_angle[f] = -std::asin(std::clamp(threads.g / (threads.p * threads.q), -1.0, 1.0));
    metrics.area_3d += triangle.area;
    metrics.area_2d += area_2d;
    if (!(area_2d > 0)) metrics.flipped_faces.push_back(chart.source_face[static_cast<std::size_t>(f)]);
  }
  metrics.arap_energy = metrics.face_arap.sum() / metrics.area_3d;
}

/// Computes E_L of Eq. (5) for the edges of wires inside the piece, then for the edges of the boundary.
void measure_wire_edges(const Chart& chart, const WireNetwork& network, const Positions2& uv, Metrics& metrics) {
  std::vector<const WireEdge*> edges;
  for (const WireEdge& edge : network.edges) edges.push_back(&edge);
  std::stable_partition(edges.begin(), edges.end(), [](const WireEdge* edge) { return !edge->is_boundary; });

  metrics.edge_length_variation.resize(static_cast<Eigen::Index>(edges.size()));
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const HalfedgeHandle h = chart.mesh.halfedge_handle(edges[i]->edge, 0);
    metrics.wire_edges.push_back(source_edge(chart, h));
    metrics.edge_length_variation[static_cast<Eigen::Index>(i)] =
        std::abs(edges[i]->length - planar_length(chart.mesh, h, uv)) / edges[i]->length;
  }
}

/// Computes the deviation θ − α of the planar angle from the surface angle at every node except tails, which have no
/// angle.
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
  // The sector is to the left of both edges: counter-clockwise from `ahead` to `back`.
  const double angle = std::atan2(cross(ahead, back), ahead.dot(back));
  return angle + 2 * kPi * std::round((node.surface_angle - angle) / (2 * kPi));
}

double measure_cloth_energy(const Chart& chart, const Positions2& flat, const Cloth& cloth) {
  const Eigen::Vector2d stretched(1 + cloth.stretch[0], 1 + cloth.stretch[1]);
  const Positions2 uv = flat * stretched.asDiagonal();
  const ClothLaw law(cloth);
  const ShapeError shape_error(chart);
  double energy = 0, area = 0;
  for (const ShapeError::Triangle& t : shape_error.triangles()) {
    energy += t.area * law.density(ShapeError::map_of(t, uv).matrix());
    area += t.area;
  }
  return energy / area / stretched.prod();  // the density is per flat area, and worn areas are larger
}

std::optional<std::string> warn_of_limits(const Chart& chart, const Metrics& metrics, const Cloth& cloth) {
  if (!cloth.limits) return std::nullopt;
  std::vector<double> areas;
  for (const FaceHandle f : chart.mesh.faces()) areas.push_back(face_area(chart.mesh, f));
  const double weft = widespread(areas, metrics.face_weft_strain);
  const double warp = widespread(areas, metrics.face_warp_strain);
  if (weft <= (*cloth.limits)[0] && warp <= (*cloth.limits)[1]) return std::nullopt;
  return "The piece stretches by " + percent(std::max(weft, 0.0)) + " across and " + percent(std::max(warp, 0.0)) +
         " along the grain. The fabric allows " + percent((*cloth.limits)[0]) + " and " + percent((*cloth.limits)[1]) +
         ". Add a dart, or choose another fabric.";
}

Metrics measure_metrics(const Chart& chart, const WireNetwork& network, const Positions2& uv, const StopToken& stop) {
  Metrics metrics;
  const Triangles faces = triangles_of(chart.mesh);
  measure_faces(chart, uv, metrics);
  measure_wire_edges(chart, network, uv, metrics);
  measure_angles(chart, network, uv, metrics);
  for (const int f : find_overlapping_faces(faces, faces_on_boundary(chart.mesh), uv, kRelativeOverlapDepth, stop)) {
    metrics.overlapping_faces.push_back(chart.source_face[f]);
  }
  return metrics;
}

}  // namespace wirewarp
