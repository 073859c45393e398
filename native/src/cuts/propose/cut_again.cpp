// SPDX-License-Identifier: GPL-3.0-or-later
#include "cuts/propose/cut_again.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "surface/cut_mesh/path_sites.h"
#include "surface/mesh/edge_table.h"
#include "surface/mesh/vertex_pairs.h"

namespace wirewarp {
namespace {

/// The default of the parameter `snap` of cut_mesh(), because users who cut along the lines of a set use this default.
constexpr double kCutSnap = 0.05;

}  // namespace

CutMesh uncut(const FlattenInput& input) {
  CutMesh mesh{input.vertices, input.faces, {}, {}};
  mesh.sources.faces.resize(static_cast<std::size_t>(input.faces.rows()));
  std::iota(mesh.sources.faces.begin(), mesh.sources.faces.end(), 0);
  mesh.sources.corner_weights = CornerWeights::Zero(input.faces.rows(), 9);
  for (const int k : {0, 4, 8}) mesh.sources.corner_weights.col(k).setOnes();
  return mesh;
}

CutMesh cut_again(const CutMesh& before, const std::vector<SurfacePath>& paths) {
  const std::vector<char> kept = not_collapsed(before.faces, static_cast<int>(before.vertices.rows()), paths);
  CutMesh after = cut_mesh(before.vertices, before.faces, selected(paths, kept), kCutSnap);
  std::map<VertexPair, std::vector<int>> divided;
  for (const std::vector<int>& along : after.sources.divided_edges)
    divided[sorted({along.front(), along.back()})] = along;
  std::set<VertexPair> edges = undirected(after.edges);
  for (const auto& [a, b] : before.edges) {
    const auto found = divided.find(sorted({a, b}));
    const std::vector<int> along = found == divided.end() ? std::vector<int>{a, b} : found->second;
    for (std::size_t i = 1; i < along.size(); ++i) edges.insert(sorted({along[i - 1], along[i]}));
  }
  after.edges.assign(edges.begin(), edges.end());
  CutSources& sources = after.sources;
  for (std::size_t f = 0; f < sources.faces.size(); ++f) {
    using Weights = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
    const auto row = static_cast<Eigen::Index>(f);
    const Eigen::Map<const Weights> first(before.sources.corner_weights.row(sources.faces[f]).data());
    Eigen::Map<Weights> weights(sources.corner_weights.row(row).data());
    weights = (weights * first).eval();
    sources.faces[f] = before.sources.faces[static_cast<std::size_t>(sources.faces[f])];
  }
  CutSources of_uncut;  // the other sources are those of the last cut only
  of_uncut.faces = std::move(sources.faces);
  of_uncut.corner_weights = std::move(sources.corner_weights);
  sources = std::move(of_uncut);
  return after;
}

std::vector<char> not_collapsed(const Triangles& faces, int num_vertices, const std::vector<SurfacePath>& paths) {
  const EdgeTable edges(faces, num_vertices);
  std::vector<char> kept(paths.size(), 1);
  while (true) {
    PathSites sites(faces, edges, num_vertices, kCutSnap);
    bool is_fewer = false;
    for (std::size_t p = 0; p < paths.size(); ++p) {
      if (kept[p] == 0) continue;
      std::set<int> passed;
      for (std::size_t i = 0; i < paths[p].faces.size(); ++i) {
        const auto row = paths[p].coordinates.row(static_cast<Eigen::Index>(i));
        passed.insert(sites.add(paths[p].faces[i], {row[0], row[1], row[2]}));
      }
      if (passed.size() > 1) continue;
      kept[p] = 0;
      is_fewer = true;
    }
    if (!is_fewer) return kept;  // otherwise tries again, as points may move elsewhere without the collapsed paths
  }
}

std::vector<SurfacePath> selected(const std::vector<SurfacePath>& paths, const std::vector<char>& flags) {
  std::vector<SurfacePath> kept;
  for (std::size_t p = 0; p < paths.size(); ++p) {
    if (flags[p] != 0) kept.push_back(paths[p]);
  }
  return kept;
}

}  // namespace wirewarp
