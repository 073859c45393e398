// SPDX-License-Identifier: GPL-3.0-or-later
#include "cuts/propose/forbidden_lines.h"

#include <algorithm>
#include <set>

#include "surface/mesh/vertex_pairs.h"

namespace wirewarp {

bool has_forbidden_lines(const CutMesh& cut, const CutOptions& cut_options) {
  std::set<VertexPair> edges = undirected(as_list(cut_options.no_seam));
  const auto follows = [&](const VertexPair& ends) { return edges.count(sorted(ends)) > 0; };
  if (std::any_of(cut.edges.begin(), cut.edges.end(), follows)) return true;
  edges.merge(undirected(as_list(cut_options.no_crossing)));
  const auto crosses = [&](const std::vector<int>& along) { return follows({along.front(), along.back()}); };
  return std::any_of(cut.sources.divided_edges.begin(), cut.sources.divided_edges.end(), crosses);
}

}  // namespace wirewarp
