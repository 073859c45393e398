// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/coarsen/wire_runs.h"

#include <Eigen/Core>
#include <array>
#include <cmath>

#include "base/planar.h"

namespace wirewarp {

std::vector<WireRun> find_wire_runs(const Chart& chart, const WireNetwork& network, const std::vector<char>& stays) {
  const auto start_of = [&](WireHalfEdge h) {
    return chart.mesh.from_vertex_handle(half_edge(chart, network, h)).idx();
  };
  const int num_edges = static_cast<int>(network.edges.size());
  // Two half-edges leave each removed vertex.
  std::vector<std::array<WireHalfEdge, 2>> leaving(chart.mesh.n_vertices());
  for (int e = 0; e < num_edges; ++e) {
    for (const WireHalfEdge h : {WireHalfEdge{e, false}, WireHalfEdge{e, true}}) {
      auto& two = leaving[start_of(h)];
      (two[0].edge == -1 ? two[0] : two[1]) = h;
    }
  }
  std::vector<WireRun> runs;
  std::vector<char> is_seen(num_edges, 0);
  for (int e = 0; e < num_edges; ++e) {
    for (WireHalfEdge h : {WireHalfEdge{e, false}, WireHalfEdge{e, true}}) {
      if (is_seen[e] || !stays[start_of(h)]) continue;
      WireRun run;
      for (;;) {
        run.half_edges.push_back(h);
        is_seen[h.edge] = 1;
        const std::size_t end = start_of(opposite(h));
        if (stays[end]) break;
        h = leaving[end][leaving[end][0].edge == h.edge ? 1 : 0];
      }
      runs.push_back(std::move(run));
    }
  }
  return runs;
}

void unroll(const WireNetwork& network, const std::vector<int>& node_at_arrival, WireRun& run) {
  const auto turn_at = [&](int node) { return kPi - network.nodes[node].surface_angle; };
  for (const WireHalfEdge h : run.half_edges) run.walked_length += network.edges[h.edge].length;
  double heading = 0, walked = 0;
  Eigen::Vector2d end(0, 0);
  for (std::size_t i = 0; i < run.half_edges.size(); ++i) {
    const double length = network.edges[run.half_edges[i].edge].length;
    end += length * Eigen::Vector2d(std::cos(heading), std::sin(heading));
    walked += length;
    run.headings.push_back(heading);
    if (i + 1 == run.half_edges.size()) break;
    const int left = node_at_arrival[place_of(run.half_edges[i])];
    const int right = node_at_arrival[place_of(opposite(run.half_edges[i + 1]))];
    if (left == -1 || right == -1) {  // on the boundary
      heading += left == -1 ? -turn_at(right) : turn_at(left);
      continue;
    }
    heading += (turn_at(left) - turn_at(right)) / 2;
    const double turning = (turn_at(left) + turn_at(right)) / 2;
    run.one_sided[0] += (1 - walked / run.walked_length) * turning;
    run.one_sided[1] += walked / run.walked_length * turning;
  }
  run.chord_length = end.norm();
  const double chord = std::atan2(end.y(), end.x());
  for (double& one : run.headings) one -= chord;
}

}  // namespace wirewarp
