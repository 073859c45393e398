// SPDX-License-Identifier: GPL-3.0-or-later
#include "warp/topology/separate_loops.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "warp/topology/shortest_path.h"
#include "warp/topology/unjoined_wires.h"

namespace wirewarp {
namespace {

/// Returns the wire edges with the same region on both sides.
std::set<int> find_hinged_edges(const WireNetwork& network) {
  std::set<int> hinged;
  for (const WirePatch& patch : network.patches) {
    std::set<int> beside;
    for (const auto& walk : patch.loops) {
      for (const WirePatch::Step& step : walk) {
        if (!beside.insert(step.half_edge.edge).second) hinged.insert(step.half_edge.edge);
      }
    }
  }
  return hinged;
}

/// Divides a walk at its hinged edges. The walk passes each hinged edge twice, and the part in between consists of the
/// loops beyond the edge.
void add_loops(const WireNetwork& network, const std::set<int>& hinged, const std::vector<WirePatch::Step>& walk,
               std::vector<WireLoop>& loops) {
  std::vector<WireLoop> found(1);
  std::vector<std::size_t> nested{0};
  std::vector<int> open;  // hinged edges passed once so far
  for (std::size_t i = 0; i < walk.size(); ++i) {
    const VertexHandle v = network.nodes[walk[i].node].vertex;
    const int edge = walk[i].half_edge.edge;
    WireLoop& loop = found[nested.back()];
    if (hinged.count(edge) == 0) {
      loop.vertices.push_back(v);
      loop.position.push_back(loop.length);
      loop.length += network.edges[edge].length;
    } else if (!open.empty() && open.back() == edge) {
      open.pop_back();
      nested.pop_back();
    } else {
      loop.joints.push_back(v);
      open.push_back(edge);
      nested.push_back(found.size());
      found.emplace_back();
      found.back().joints.push_back(network.nodes[walk[(i + 1) % walk.size()].node].vertex);
    }
  }
  for (WireLoop& loop : found) {
    if (!loop.vertices.empty()) loops.push_back(std::move(loop));
  }
}

/// Returns the shortest of the loops with at most one wire to other loops.
std::size_t choose_loop(const std::vector<WireLoop>& loops) {
  std::size_t chosen = loops.size();
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (loops[i].joints.size() > 1) continue;
    if (chosen == loops.size() || loops[i].length < loops[chosen].length) chosen = i;
  }
  if (chosen == loops.size()) throw UnjoinedWires("Wire loops form a ring with the same region on both sides.");
  return chosen;
}

std::size_t index_of(const WireLoop& loop, VertexHandle v) {
  return static_cast<std::size_t>(std::find(loop.vertices.begin(), loop.vertices.end(), v) - loop.vertices.begin());
}

/// Returns the vertex whose distance along the loop from a given vertex is nearest to the given distance.
std::size_t vertex_at_distance(const WireLoop& loop, std::size_t from, double distance) {
  const double goal = std::fmod(loop.position[from] + distance, loop.length);
  const auto miss = [&](std::size_t i) {
    const double gap = std::abs(loop.position[i] - goal);
    return std::min(gap, loop.length - gap);
  };
  std::size_t nearest = 0;
  for (std::size_t i = 1; i < loop.vertices.size(); ++i) {
    if (miss(i) < miss(nearest)) nearest = i;
  }
  return nearest;
}

/// Joins a loop to others by four paths. The first, the shortest path, is omitted if a wire already leads to another
/// loop. The other paths begin at 1/4, 1/2 and 3/4 of the loop's length from the first.
void join_loop(SplitChart& split, const std::vector<WireLoop>& loops, const WireLoop& loop) {
  std::vector<char> is_target(split.chart.mesh.n_vertices(), 0);
  for (const WireLoop& other : loops) {
    if (&other == &loop) continue;
    for (const VertexHandle v : other.vertices) is_target[v.idx()] = 1;
  }
  VertexHandle first;
  if (loop.joints.empty()) {
    const HalfEdgeChain path = join_by_shortest_path(split, loop.vertices, is_target);
    first = split.chart.mesh.from_vertex_handle(path.front());
  } else {
    first = loop.joints.front();
  }
  const std::size_t start = index_of(loop, first);
  const std::size_t farthest = vertex_at_distance(loop, start, loop.length / 2);
  const double halfway = std::fmod(loop.position[farthest] - loop.position[start] + loop.length, loop.length) / 2;
  std::set<int> joined{first.idx()};
  for (const std::size_t i : {farthest, vertex_at_distance(loop, start, halfway),
                              vertex_at_distance(loop, farthest, (loop.length - 2 * halfway) / 2)}) {
    if (!joined.insert(loop.vertices[i].idx()).second) continue;  // the loop has fewer than four vertices
    join_by_shortest_path(split, {loop.vertices[i]}, is_target);
  }
}

}  // namespace

std::vector<WireLoop> find_separate_loops(const WireNetwork& network) {
  const std::set<int> hinged = find_hinged_edges(network);
  for (const WirePatch& patch : network.patches) {
    std::vector<WireLoop> loops;
    for (const auto& walk : patch.loops) add_loops(network, hinged, walk, loops);
    if (loops.size() > 1) return loops;
  }
  return {};
}

void join_separate_loops(SplitChart& split, WorkMeter& work) {
  // Every round reduces the number of loops or of edges with the same region on both sides, so the rounds end.
  for (std::size_t rounds_left = split.chart.mesh.n_edges(); rounds_left > 0; --rounds_left) {
    const std::vector<WireLoop> loops = find_separate_loops(build_wire_network(split.chart));
    if (loops.empty()) return;
    work.did(split.chart.mesh.n_edges());
    join_loop(split, loops, loops[choose_loop(loops)]);
  }
}

}  // namespace wirewarp
