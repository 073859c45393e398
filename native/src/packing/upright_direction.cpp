// SPDX-License-Identifier: GPL-3.0-or-later
#include "packing/upright_direction.h"

#include "mesh/geometry.h"

namespace wirewarp {
namespace {

// Lengths closer than this are the same: rounding must not choose between the two sides of a symmetric piece.
constexpr double kSameLength = 1e-6;

// A chord below this fraction of its chain's length says nothing about where the chain leads.
constexpr double kShortChord = 0.1;

double length_of(const HalfEdgeMesh& mesh, const HalfEdgeChain& chain) {
  double length = 0;
  for (const HalfedgeHandle h : chain) length += edge_length(mesh, h);
  return length;
}

/// Index of the first point that is as far from points[from] as any.
std::size_t farthest(const std::vector<Eigen::Vector2d>& points, std::size_t from) {
  std::size_t best = from;
  double best_distance = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double distance = (points[i] - points[from]).norm();
    if (distance <= best_distance * (1 + kSameLength)) continue;
    best = i;
    best_distance = distance;
  }
  return best;
}

Eigen::Vector2d direction_of(const Chart& chart, const HalfEdgeChain& chain, const Positions2& uv) {
  std::vector<Eigen::Vector2d> points;
  points.push_back(uv.row(chart.mesh.from_vertex_handle(chain.front()).idx()));
  for (const HalfedgeHandle h : chain) points.push_back(uv.row(chart.mesh.to_vertex_handle(h).idx()));

  const Eigen::Vector2d chord = points.back() - points.front();
  if (chord.norm() >= kShortChord * length_of(chart.mesh, chain)) return chord;
  const std::size_t one_end = farthest(points, 0);
  const std::size_t other_end = farthest(points, one_end);
  return points[std::max(one_end, other_end)] - points[std::min(one_end, other_end)];
}

const HalfEdgeChain& longest_boundary_chain(const Chart& chart) {
  const HalfEdgeChain* best = nullptr;
  double best_length = 0;
  for (const BoundaryChain& chain : chart.boundary_chains) {
    const double length = length_of(chart.mesh, chain.half_edges);
    if (best && length <= best_length * (1 + kSameLength)) continue;
    best = &chain.half_edges;
    best_length = length;
  }
  return *best;
}

}  // namespace

Eigen::Vector2d upright_direction(const Chart& chart, const Positions2& uv) {
  const HalfEdgeChain& chain =
      chart.wire_parts.empty() ? longest_boundary_chain(chart) : chart.wire_parts.front().half_edges;
  return direction_of(chart, chain, uv);
}

}  // namespace wirewarp
