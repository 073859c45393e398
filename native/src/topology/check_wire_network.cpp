// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <set>

#include "check_input/sentence.h"
#include "index.h"
#include "topology/wire_network.h"

namespace wirewarp {
namespace {

/// A wire edge is hinged where the same wire-patch lies on both its sides (paper, Definition 1).
void check_hinged_wires(const Chart& chart, const WireNetwork& network, const std::vector<Wire>& wires) {
  std::vector<std::array<int, 2>> patch_beside(network.edges.size(), {-1, -1});
  for (int p = 0; p < static_cast<int>(network.patches.size()); ++p) {
    for (const auto& loop : network.patches[at(p)].loops) {
      for (const WirePatch::Step& step : loop) {
        patch_beside[at(step.half_edge.edge)][step.half_edge.reversed ? 1 : 0] = p;
      }
    }
  }
  std::set<int> hinged_wires;
  ErrorElements elements;
  std::map<int, int> hinged_degree;  // of chart vertices
  for (std::size_t e = 0; e < network.edges.size(); ++e) {
    if (network.edges[e].is_boundary || patch_beside[e][0] != patch_beside[e][1]) continue;
    const HalfedgeHandle h = chart.mesh.halfedge_handle(network.edges[e].edge, 0);
    const VertexHandle from = chart.mesh.from_vertex_handle(h);
    const VertexHandle to = chart.mesh.to_vertex_handle(h);
    hinged_wires.insert(chart.wire_parts[at(network.edges[e].part)].wire_index);
    elements.edges.push_back(source_edge(chart, h));
    ++hinged_degree[from.idx()];
    ++hinged_degree[to.idx()];
  }
  if (hinged_wires.empty()) return;

  for (const WireNode& node : network.nodes) {
    if (node.is_tail) elements.vertices.push_back(chart.source_vertex[at(node.vertex.idx())]);
  }
  const bool is_single = hinged_wires.size() == 1;
  std::string problem;
  if (!elements.vertices.empty()) {
    problem = (is_single ? " ends inside a piece at " : " end inside a piece at ") +
              name_elements("vertex", elements.vertices) +
              ": extend to a seam, a boundary or another wire, or clear the loose edges.";
  } else {
    for (const auto& [vertex, degree] : hinged_degree) {
      if (degree == 1) elements.vertices.push_back(chart.source_vertex[at(vertex)]);
    }
    problem = (is_single ? " is" : " are") +
              std::string(" the only link between two loops, with one region on both sides, through ") +
              name_elements("vertex", elements.vertices) + ": mark a second wire between the loops.";
  }
  throw FlattenError(ErrorCode::hinged_wire,
                     capitalized(name_wires(wires, {hinged_wires.begin(), hinged_wires.end()})) + problem, elements);
}

void check_separate_loops(const Chart& chart, const WireNetwork& network, const std::vector<Wire>& wires) {
  for (const WirePatch& patch : network.patches) {
    if (patch.loops.size() == 1) continue;
    ErrorElements elements;
    std::vector<int> one_per_loop;
    std::set<int> loop_wires;
    for (const auto& loop : patch.loops) {
      one_per_loop.push_back(chart.source_vertex[at(network.nodes[at(loop[0].node)].vertex.idx())]);
      for (const WirePatch::Step& step : loop) {
        elements.vertices.push_back(chart.source_vertex[at(network.nodes[at(step.node)].vertex.idx())]);
        const int part = network.edges[at(step.half_edge.edge)].part;
        if (part >= 0) loop_wires.insert(chart.wire_parts[at(part)].wire_index);
      }
    }
    if (!has_wires(chart)) {
      throw FlattenError(ErrorCode::separate_loops,
                         "This piece is a tube or has a hole: mark a seam between its loops through " +
                             name_elements("vertex", one_per_loop) + ", or two wires.",
                         elements);
    }
    const std::string beside =
        loop_wires.empty() ? "" : " beside " + name_wires(wires, {loop_wires.begin(), loop_wires.end()});
    throw FlattenError(ErrorCode::separate_loops,
                       "A region" + beside + " is bounded by " + std::to_string(patch.loops.size()) +
                           " loops that no wire joins, through " + name_elements("vertex", one_per_loop) +
                           ": mark two wires between them, or a seam.",
                       elements);
  }
}

}  // namespace

void check_wire_network(const Chart& chart, const WireNetwork& network, const std::vector<Wire>& wires) {
  check_hinged_wires(chart, network, wires);
  check_separate_loops(chart, network, wires);
}

}  // namespace wirewarp
