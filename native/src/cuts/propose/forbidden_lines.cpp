// SPDX-License-Identifier: GPL-3.0-or-later
#include "cuts/propose/forbidden_lines.h"

#include <algorithm>
#include <set>

#include "surface/charts/chart.h"

namespace wirewarp {
namespace {

void insert(const VertexPairs& pairs, std::set<VertexPair>& edges) {
  for (const auto& ends : pairs.rowwise()) edges.insert(sorted({ends[0], ends[1]}));
}

}  // namespace

bool has_forbidden_lines(const CutMesh& cut, const CutOptions& cut_options) {
  std::set<VertexPair> edges;
  insert(cut_options.no_seam, edges);
  const auto follows = [&](const VertexPair& ends) { return edges.count(sorted(ends)) > 0; };
  if (std::any_of(cut.edges.begin(), cut.edges.end(), follows)) return true;
  insert(cut_options.no_crossing, edges);
  const auto crosses = [&](const std::vector<int>& along) { return follows({along.front(), along.back()}); };
  return std::any_of(cut.sources.divided_edges.begin(), cut.sources.divided_edges.end(), crosses);
}

}  // namespace wirewarp
