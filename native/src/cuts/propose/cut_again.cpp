// SPDX-License-Identifier: GPL-3.0-or-later
#include "cuts/propose/cut_again.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "surface/cut_mesh/path_sites.h"
#include "surface/mesh/edge_table.h"

namespace wirewarp {
namespace {

/// The default of cut_mesh(), which callers use to cut along the lines of a set.
constexpr double kCutSnap = 0.05;

VertexPair ordered(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

}  // namespace

CutMesh uncut(const FlattenInput& input) {
  CutMesh mesh{input.vertices, input.faces, {}, {}};
  mesh.sources.faces.resize(static_cast<std::size_t>(input.faces.rows()));
  std::iota(mesh.sources.faces.begin(), mesh.sources.faces.end(), 0);
  mesh.sources.corner_weights = CornerWeights::Zero(input.faces.rows(), 9);
  for (const int k : {0, 4, 8}) mesh.sources.corner_weights.col(k).setOnes();
  return mesh;
}

CutMesh cut_again(const CutMesh& before, std::vector<SurfacePath> paths) {
  const auto num_vertices = static_cast<int>(before.vertices.rows());
  CutMesh after = cut_mesh(before.vertices, before.faces,
                           without_collapsed(before.faces, num_vertices, std::move(paths)), kCutSnap);
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
  for (std::size_t f = 0; f < sources.faces.size(); ++f) {
    using Weights = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
    const auto row = static_cast<Eigen::Index>(f);
    const Eigen::Map<const Weights> first(before.sources.corner_weights.row(sources.faces[f]).data());
    Eigen::Map<Weights> weights(sources.corner_weights.row(row).data());
    weights = (weights * first).eval();
    sources.faces[f] = before.sources.faces[static_cast<std::size_t>(sources.faces[f])];
  }
  return after;
}

std::vector<SurfacePath> without_collapsed(const Triangles& faces, int num_vertices, std::vector<SurfacePath> paths) {
  const EdgeTable edges(faces, num_vertices);
  while (true) {
    PathSites sites(faces, edges, num_vertices, kCutSnap);
    const auto is_collapsed = [&](const SurfacePath& path) {
      std::set<int> passed;
      for (std::size_t i = 0; i < path.faces.size(); ++i) {
        const auto row = path.coordinates.row(static_cast<Eigen::Index>(i));
        passed.insert(sites.add(path.faces[i], {row[0], row[1], row[2]}));
      }
      return passed.size() < 2;
    };
    const auto kept = std::remove_if(paths.begin(), paths.end(), is_collapsed);
    if (kept == paths.end()) return paths;
    paths.erase(kept, paths.end());  // other points may move elsewhere without these
  }
}

}  // namespace wirewarp
