// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <queue>
#include <set>

#include "random_input.h"

namespace wirewarp::test {
namespace {

/// The neighbors of each vertex of a mesh, and the number of faces of each edge.
struct EdgeGraph {
  std::vector<std::vector<int>> neighbors;
  std::map<Edge, int> num_faces;

  explicit EdgeGraph(const FlattenInput& input) : neighbors(input.vertices.rows()) {
    for (int f = 0; f < input.faces.rows(); ++f) {
      for (int k = 0; k < 3; ++k) ++num_faces[edge_of(input.faces(f, k), input.faces(f, (k + 1) % 3))];
    }
    for (const auto& [edge, count] : num_faces) {
      neighbors[edge[0]].push_back(edge[1]);
      neighbors[edge[1]].push_back(edge[0]);
    }
  }

  std::vector<int> border_vertices() const {
    std::set<int> found;
    for (const auto& [edge, count] : num_faces) {
      if (count == 1) found.insert(edge.begin(), edge.end());
    }
    return {found.begin(), found.end()};
  }
};

/// Returns a walk along edges that are not in `used`, and adds its edges to `used`. The walk may end early and may
/// cross itself.
std::vector<int> random_walk(RandomStream& random, const EdgeGraph& graph, int from, int steps, std::set<Edge>& used) {
  std::vector<int> chain{from};
  for (int i = 0; i < steps; ++i) {
    std::vector<int> open;
    for (const int next : graph.neighbors[chain.back()]) {
      if (!used.count(edge_of(chain.back(), next))) open.push_back(next);
    }
    if (open.empty()) break;
    const int next = random.pick(open);
    used.insert(edge_of(chain.back(), next));
    chain.push_back(next);
  }
  return chain;
}

/// Returns the shortest path, by number of edges, along edges that are not in `used`. Adds the path's edges to `used`.
/// Returns one vertex if there is no path.
std::vector<int> short_path(const EdgeGraph& graph, int from, int to, std::set<Edge>& used) {
  std::map<int, int> previous{{from, from}};
  std::queue<int> front;
  front.push(from);
  while (!front.empty() && !previous.count(to)) {
    const int v = front.front();
    front.pop();
    for (const int next : graph.neighbors[v]) {
      if (previous.count(next) || used.count(edge_of(v, next))) continue;
      previous[next] = v;
      front.push(next);
    }
  }
  if (!previous.count(to)) return {from};
  std::vector<int> chain{to};
  while (chain.back() != from) {
    used.insert(edge_of(chain.back(), previous[chain.back()]));
    chain.push_back(previous[chain.back()]);
  }
  return chain;
}

std::vector<int> random_chain(RandomStream& random, const EdgeGraph& graph, const std::vector<int>& used_vertices,
                              std::set<Edge>& used) {
  const std::vector<int> border = graph.border_vertices();
  const int from = random.chance(0.5) && !border.empty() ? random.pick(border) : random.pick(used_vertices);
  if (random.chance(0.4)) return random_walk(random, graph, from, random.whole(1, 12), used);
  const int to = random.chance(0.6) && !border.empty() ? random.pick(border) : random.pick(used_vertices);
  std::vector<int> chain = short_path(graph, from, to, used);
  if (chain.size() > 2 && random.chance(0.2)) {  // closes the chain along another path
    std::vector<int> back = short_path(graph, to, from, used);
    if (back.size() > 1) {
      std::reverse(chain.begin(), chain.end());
      std::reverse(back.begin(), back.end());
      chain.insert(chain.end(), back.begin() + 1, back.end());
    }
  }
  return chain;
}

/// Adds a small cut. It is a dart of a few edges from a border, a slit of a few edges inside, or a loop around a
/// vertex.
void add_small_cut(RandomStream& random, const FlattenInput& input, const EdgeGraph& graph,
                   const std::vector<int>& used_vertices, std::set<Edge>& seams) {
  const int kind = random.below(5);
  const std::vector<int> border = graph.border_vertices();
  const std::set<int> on_border(border.begin(), border.end());
  std::vector<int> inside;
  std::copy_if(used_vertices.begin(), used_vertices.end(), std::back_inserter(inside),
               [&](int v) { return on_border.count(v) == 0; });
  const std::vector<int>& starts = kind == 0 ? border : inside;
  if (starts.empty()) return;
  const int start = random.pick(starts);
  if (kind < 4) {
    random_walk(random, graph, start, random.chance(0.4) ? 1 : random.whole(1, 4), seams);
    return;
  }
  for (const auto& face : input.faces.rowwise()) {
    for (int k = 0; k < 3; ++k) {
      if (face[k] == start) seams.insert(edge_of(face[(k + 1) % 3], face[(k + 2) % 3]));
    }
  }
}

std::vector<int> vertices_of_faces(const FlattenInput& input) {
  const std::set<int> found(input.faces.data(), input.faces.data() + input.faces.size());
  return {found.begin(), found.end()};
}

}  // namespace

void add_random_seams(RandomStream& random, FlattenInput& input, std::string& description) {
  const int count = random.chance(0.5) ? 0 : random.whole(1, 4);
  const EdgeGraph graph(input);
  const std::vector<int> vertices = vertices_of_faces(input);
  std::set<Edge> seams;
  const bool are_small = random.chance(0.5);
  for (int i = 0; i < count; ++i) {
    if (are_small) {
      add_small_cut(random, input, graph, vertices, seams);
    } else {
      random_chain(random, graph, vertices, seams);
    }
  }
  input.seams.resize(seams.size(), 2);
  Eigen::Index row = 0;
  for (const Edge& seam : seams) {
    const bool turned = random.chance(0.5);
    input.seams.row(row++) << seam[turned ? 1 : 0], seam[turned ? 0 : 1];
  }
  if (count > 0) description += are_small ? " small-cuts" : " seams";
}

void add_random_wires(RandomStream& random, FlattenInput& input, std::string& description) {
  const int count = random.chance(0.05) ? random.whole(20, 80) : random.chance(0.3) ? 0 : random.whole(1, 5);
  const bool all_rigid = random.chance(0.2);
  const EdgeGraph graph(input);
  const std::vector<int> vertices = vertices_of_faces(input);
  const std::vector<double> tolerances{0, 0, 0.001, 0.03, 0.05, 0.2, 0.999, std::numeric_limits<double>::infinity()};
  std::set<Edge> used;
  for (int i = 0; i < count; ++i) {
    const std::vector<int> chain = random_chain(random, graph, vertices, used);
    if (chain.size() < 2) continue;
    input.wires.push_back({chain, all_rigid ? 0 : random.pick(tolerances), "wire " + std::to_string(i)});
  }
  if (!input.wires.empty()) description += " " + std::to_string(input.wires.size()) + "-wires";
}

}  // namespace wirewarp::test
