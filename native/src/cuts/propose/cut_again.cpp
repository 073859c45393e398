// SPDX-License-Identifier: GPL-3.0-or-later
#include "cuts/propose/cut_again.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace wirewarp {
namespace {

/// cut_mesh() moves points to one if their coordinates differ by less: its default `snap`.
constexpr double kOnePlace = 0.05;

VertexPair ordered(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

}  // namespace

CutMesh uncut(const FlattenInput& input) {
  CutMesh mesh{input.vertices, input.faces, {}, {}};
  const Eigen::Index n = input.vertices.rows();
  mesh.sources.vertices.resize(n, 3);
  mesh.sources.vertex_weights = Positions3::Zero(n, 3);
  for (Eigen::Index v = 0; v < n; ++v) mesh.sources.vertices.row(v).setConstant(static_cast<int>(v));
  mesh.sources.vertex_weights.col(0).setOnes();
  mesh.sources.faces.resize(static_cast<std::size_t>(input.faces.rows()));
  std::iota(mesh.sources.faces.begin(), mesh.sources.faces.end(), 0);
  return mesh;
}

CutMesh cut_again(const CutMesh& before, const std::vector<SurfacePath>& paths) {
  CutMesh after = cut_mesh(before.vertices, before.faces, paths);
  std::map<VertexPair, std::vector<int>> divided;
  for (const std::vector<int>& along : after.sources.divided_edges)
    divided[ordered(along.front(), along.back())] = along;
  std::set<VertexPair> edges;
  for (const auto& [a, b] : after.edges) edges.insert(ordered(a, b));
  for (const auto& [a, b] : before.edges) {
    const auto found = divided.find(ordered(a, b));
    const std::vector<int> along = found == divided.end() ? std::vector<int>{a, b} : found->second;
    for (std::size_t i = 1; i < along.size(); ++i) edges.insert(ordered(along[i - 1], along[i]));
  }
  after.edges.assign(edges.begin(), edges.end());
  CutSources& sources = after.sources;
  for (int& face : sources.faces) face = before.sources.faces[static_cast<std::size_t>(face)];
  for (int v = 0; v < static_cast<int>(after.vertices.rows()); ++v) {
    std::map<int, double> weights;
    for (const auto& [w, weight] : weights_of(sources, v)) {
      for (const auto& [first, share] : weights_of(before.sources, w)) weights[first] += weight * share;
    }
    sources.vertices.row(v).setConstant(weights.begin()->first);
    sources.vertex_weights.row(v).setZero();
    Eigen::Index k = 0;
    for (const auto& [first, weight] : weights) {
      sources.vertices(v, k) = first;
      sources.vertex_weights(v, k++) = weight;
    }
  }
  return after;
}

std::map<int, double> weights_of(const CutSources& sources, int vertex) {
  std::map<int, double> weights;
  for (int k = 0; k < 3; ++k) {
    if (sources.vertex_weights(vertex, k) != 0)
      weights[sources.vertices(vertex, k)] += sources.vertex_weights(vertex, k);
  }
  return weights;
}

bool is_one_place(const Triangles& faces, const SurfacePath& path) {
  const auto weights_at = [&](std::size_t i) {
    std::map<int, double> weights;
    for (int k = 0; k < 3; ++k) weights[faces(path.faces[i], k)] += path.coordinates(static_cast<Eigen::Index>(i), k);
    return weights;
  };
  const std::map<int, double> first = weights_at(0);
  for (std::size_t i = 1; i < path.faces.size(); ++i) {
    std::map<int, double> difference = weights_at(i);
    for (const auto& [v, weight] : first) difference[v] -= weight;
    for (const auto& each : difference) {
      if (std::abs(each.second) >= kOnePlace) return false;
    }
  }
  return true;
}

}  // namespace wirewarp
