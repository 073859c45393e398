// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/charts/chart_faults.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>

#include "base/disjoint_sets.h"

namespace wirewarp {
namespace {

/// A triangle counts as having zero area if its height over the longest side is below this fraction of that side.
constexpr double kFlatness = 1e-12;

/// A triangle also counts as having zero area if its longest side is below this, scene units: squared areas would
/// underflow.
constexpr double kShortest = 1e-60;

struct Faults {
  std::vector<int> repeated_vertex;  // faces
  std::vector<int> repeated_face;    // faces
  std::vector<int> zero_area;        // faces
  std::vector<VertexPair> non_manifold;
  std::vector<VertexPair> turned;  // edges whose two faces have opposite orientations
  std::vector<int> pinched;        // vertices at which faces touch without a common edge
  bool is_one_sided = false;
};

bool repeats_vertex(const Triangles& faces, int f) {
  return faces(f, 0) == faces(f, 1) || faces(f, 1) == faces(f, 2) || faces(f, 2) == faces(f, 0);
}

bool has_no_area(const FlattenInput& input, int f) {
  const Eigen::Vector3d a = input.vertices.row(input.faces(f, 0));
  const Eigen::Vector3d b = input.vertices.row(input.faces(f, 1));
  const Eigen::Vector3d c = input.vertices.row(input.faces(f, 2));
  const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
  return longest < kShortest || ((b - a) / longest).cross((c - a) / longest).norm() <= kFlatness;
}

int opposite_vertex(const Triangles& faces, int side) { return faces(side / 3, (side + 2) % 3); }

void find_face_faults(const FlattenInput& input, const SurfaceCut& cut, std::vector<Faults>& faults) {
  for (int f = 0; f < input.faces.rows(); ++f) {
    Faults& chart = faults[cut.chart_of_face[f]];
    if (repeats_vertex(input.faces, f)) {
      chart.repeated_vertex.push_back(f);
    } else if (has_no_area(input, f)) {
      chart.zero_area.push_back(f);
    }
  }
}

void find_edge_faults(const FlattenInput& input, const EdgeTable& edges, const SurfaceCut& cut,
                      std::vector<Faults>& faults) {
  const auto chart_of_side = [&](int side) -> Faults& { return faults[cut.chart_of_face[side / 3]]; };
  for (int e = 0; e < edges.num_edges(); ++e) {
    const int num_sides = edges.num_sides(e);
    if (num_sides < 2) continue;
    // Two faces with the same three vertices share three edges, so only the edge between their two smallest vertices is
    // checked.
    for (int j = 1; j < num_sides; ++j) {
      const int third = opposite_vertex(input.faces, edges.side(e, j));
      if (third < edges.vertices(e)[1]) continue;
      for (int i = 0; i < j; ++i) {
        if (opposite_vertex(input.faces, edges.side(e, i)) != third) continue;
        chart_of_side(edges.side(e, j)).repeated_face.push_back(edges.side(e, j) / 3);
        break;
      }
    }
    if (cut.is_seam[e]) continue;
    if (num_sides > 2) {
      chart_of_side(edges.side(e, 0)).non_manifold.push_back(edges.vertices(e));
    } else if (edges.from(edges.side(e, 0)) == edges.from(edges.side(e, 1))) {
      chart_of_side(edges.side(e, 0)).turned.push_back(edges.vertices(e));
    }
  }
}

/// Finds the charts that cannot be oriented by flipping faces. Uses two copies of each face, original and flipped: a
/// chart is one-sided if its edges connect a face with its flipped copy.
void find_one_sided(const EdgeTable& edges, const SurfaceCut& cut, std::vector<Faults>& faults) {
  const auto none_turned = [](const Faults& chart) { return chart.turned.empty(); };
  if (std::all_of(faults.begin(), faults.end(), none_turned)) return;
  const auto num_faces = static_cast<int>(cut.chart_of_face.size());
  DisjointSets sides(2 * cut.chart_of_face.size());
  for (int e = 0; e < edges.num_edges(); ++e) {
    if (edges.num_sides(e) != 2 || cut.is_seam[e]) continue;
    const int f = edges.side(e, 0) / 3, g = edges.side(e, 1) / 3;
    const bool is_turned = edges.from(edges.side(e, 0)) == edges.from(edges.side(e, 1));
    sides.unite(f, is_turned ? g + num_faces : g);
    sides.unite(f + num_faces, is_turned ? g : g + num_faces);
  }
  for (int f = 0; f < num_faces; ++f) {
    if (sides.find(f) == sides.find(f + num_faces)) faults[cut.chart_of_face[f]].is_one_sided = true;
  }
}

/// Finds vertices at which faces of one chart touch without an edge that connects them.
void find_vertex_faults(const FlattenInput& input, const EdgeTable& edges, const SurfaceCut& cut,
                        const std::vector<int>& fans, std::vector<Faults>& faults) {
  std::vector<int> across_seams = fans;
  if (fans.empty() && input.seams.rows() > 0) across_seams = fans_of_uncut_surface(input.faces, edges);
  const std::vector<int>& fan = across_seams.empty() ? cut.fan_of_corner : across_seams;
  std::vector<int> first_fan(static_cast<std::size_t>(input.vertices.rows()), -1);
  std::vector<char> has_several(static_cast<std::size_t>(input.vertices.rows()), 0);
  for (std::size_t corner = 0; corner < fan.size(); ++corner) {
    const auto v = static_cast<std::size_t>(input.faces.data()[corner]);
    if (first_fan[v] < 0) first_fan[v] = fan[corner];
    if (fan[corner] != first_fan[v]) has_several[v] = 1;
  }
  std::map<VertexPair, int> fan_in_chart;  // keyed by chart and vertex
  for (std::size_t corner = 0; corner < fan.size(); ++corner) {
    const int v = input.faces.data()[corner];
    if (!has_several[v]) continue;
    const int chart = cut.chart_of_face[corner / 3];
    const int first = fan_in_chart.insert({{chart, v}, fan[corner]}).first->second;
    if (fan[corner] != first) faults[chart].pinched.push_back(v);
  }
  for (Faults& of_chart : faults) {
    std::sort(of_chart.pinched.begin(), of_chart.pinched.end());
    of_chart.pinched.erase(std::unique(of_chart.pinched.begin(), of_chart.pinched.end()), of_chart.pinched.end());
  }
}

FlattenError at_faces(ErrorCode code, const std::vector<int>& faces) {
  return FlattenError(code, ErrorArguments{}, {{}, {}, faces});
}

std::optional<FlattenError> first_fault(const Faults& faults) {
  if (!faults.repeated_vertex.empty()) {
    return at_faces(ErrorCode::repeated_vertex_in_face, faults.repeated_vertex);
  }
  if (!faults.repeated_face.empty()) return at_faces(ErrorCode::repeated_face, faults.repeated_face);
  if (!faults.zero_area.empty()) return at_faces(ErrorCode::zero_area_face, faults.zero_area);
  if (!faults.non_manifold.empty()) {
    return FlattenError(ErrorCode::non_manifold_edge, ErrorArguments{},
                        {{}, faults.non_manifold, {}, faults.non_manifold});
  }
  if (!faults.turned.empty()) {
    // Flipping faces fixes a two-sided surface; only a seam fixes a one-sided surface.
    return FlattenError(ErrorCode::inconsistent_orientation, ErrorArguments{{"is_one_sided", faults.is_one_sided}},
                        {{}, faults.turned, {}, faults.is_one_sided ? faults.turned : std::vector<VertexPair>()});
  }
  if (!faults.pinched.empty()) {
    return FlattenError(ErrorCode::non_manifold_vertex, ErrorArguments{}, {faults.pinched, {}, {}});
  }
  return std::nullopt;
}

}  // namespace

std::vector<std::optional<FlattenError>> find_chart_faults(const FlattenInput& input, const EdgeTable& edges,
                                                           const SurfaceCut& cut, const std::vector<int>& fans) {
  std::vector<Faults> faults(cut.num_charts);
  find_face_faults(input, cut, faults);
  find_edge_faults(input, edges, cut, faults);
  find_one_sided(edges, cut, faults);
  find_vertex_faults(input, edges, cut, fans, faults);
  std::vector<std::optional<FlattenError>> errors;
  errors.reserve(faults.size());
  for (const Faults& chart : faults) errors.push_back(first_fault(chart));
  return errors;
}

long count_handles(const Chart& chart) {
  // Euler's formula: V - E + F = 2 - 2 handles - loops.
  const long euler = static_cast<long>(chart.mesh.n_vertices()) - static_cast<long>(chart.mesh.n_edges()) +
                     static_cast<long>(chart.mesh.n_faces());
  return (2 - static_cast<long>(chart.boundary_loops.size()) - euler) / 2;
}

std::optional<FlattenError> find_topology_fault(const Chart& chart) {
  if (chart.boundary_loops.empty()) {
    return FlattenError(ErrorCode::closed_chart, ErrorArguments{}, {{}, {}, chart.source_face});
  }
  const long handles = count_handles(chart);
  if (handles == 0) return std::nullopt;
  return FlattenError(ErrorCode::handles, ErrorArguments{{"num_handles", static_cast<int>(handles)}},
                      {{}, {}, chart.source_face});
}

}  // namespace wirewarp
