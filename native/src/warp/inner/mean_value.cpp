// SPDX-License-Identifier: GPL-3.0-or-later
#include "warp/inner/mean_value.h"

#include <cstddef>

namespace wirewarp {
namespace {

/// Returns tan(α/2) of the angle α between two vectors of the given lengths. Uses the quotient without cancellation:
/// sin α / (1 + cos α) or (1 - cos α) / sin α.
double tan_half_angle(const OpenMesh::Vec3d& a, const OpenMesh::Vec3d& b, double a_length, double b_length) {
  const double area = OpenMesh::cross(a, b).norm();
  const double dot = OpenMesh::dot(a, b);
  const double product = a_length * b_length;
  return dot >= 0 ? area / (product + dot) : (product - dot) / area;
}

}  // namespace

void mean_value_weights(const HalfEdgeMesh& mesh, VertexHandle center, std::vector<WeightedVertex>& ring) {
  ring.clear();
  for (const VertexHandle neighbor : mesh.vv_range(center)) ring.push_back({neighbor, 0});

  const OpenMesh::Vec3d& origin = mesh.point(center);
  OpenMesh::Vec3d edge = mesh.point(ring.back().vertex) - origin;
  double length = edge.norm();
  double sum = 0;
  for (std::size_t j = 0, previous = ring.size() - 1; j < ring.size(); previous = j++) {
    const OpenMesh::Vec3d next = mesh.point(ring[j].vertex) - origin;
    const double next_length = next.norm();
    const double tan_half = tan_half_angle(edge, next, length, next_length);
    ring[previous].weight += tan_half / length;
    ring[j].weight += tan_half / next_length;
    sum += tan_half / length + tan_half / next_length;
    edge = next;
    length = next_length;
  }
  for (WeightedVertex& neighbor : ring) neighbor.weight /= sum;
}

}  // namespace wirewarp
