// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>

#include "base/arguments.h"
#include "surface/charts/cut_into_charts.h"
#include "surface/check_input/check_input.h"
#include "warp/topology/smooth_line.h"
#include "wirewarp/straighten.h"

namespace wirewarp {
namespace {

/// Finds edges of the input inside charts.
class InnerEdges {
 public:
  explicit InnerEdges(const std::vector<Chart>& charts) : charts_(charts) {
    for (std::size_t c = 0; c < charts.size(); ++c) {
      for (const VertexHandle v : charts[c].mesh.vertices())
        copies_.emplace(charts[c].source_vertex[v.idx()], Copy{c, v});
    }
  }

  struct Side {
    std::size_t chart;
    HalfedgeHandle half_edge;  // invalid if the edge does not exist or is on a seam or outline
  };

  Side find(int from, int to) const {
    const auto [begin, end] = copies_.equal_range(from);
    for (auto copy = begin; copy != end; ++copy) {
      const Chart& chart = charts_[copy->second.chart];
      for (const HalfedgeHandle h : chart.mesh.voh_range(copy->second.vertex)) {
        const bool leads_there = chart.source_vertex[chart.mesh.to_vertex_handle(h).idx()] == to;
        if (leads_there && !chart.mesh.is_boundary(chart.mesh.edge_handle(h))) return {copy->second.chart, h};
      }
    }
    return {0, HalfedgeHandle()};
  }

 private:
  struct Copy {
    std::size_t chart;
    VertexHandle vertex;
  };

  const std::vector<Chart>& charts_;
  std::unordered_multimap<int, Copy> copies_;  // keyed by input vertex
};

/// Returns the edges and vertices of a chart that are on the outline or on wires of the input.
WireMask lines_of(const Chart& chart, const std::set<VertexPair>& wire_edges) {
  WireMask lines;
  for (const EdgeHandle e : chart.mesh.edges()) {
    const HalfedgeHandle h = chart.mesh.halfedge_handle(e, 0);
    if (chart.mesh.is_boundary(e) || wire_edges.count(source_edge(chart, h)) != 0) lines.add(chart.mesh, h);
  }
  return lines;
}

std::set<VertexPair> edges_of(const std::vector<Wire>& wires) {
  std::set<VertexPair> edges;
  for (const Wire& wire : wires) {
    for (std::size_t i = 1; i < wire.vertices.size(); ++i) {
      const auto [first, last] = std::minmax(wire.vertices[i - 1], wire.vertices[i]);
      edges.insert({first, last});
    }
  }
  return edges;
}

LinePoint in_input(const Chart& chart, const PathPoint& point) {
  const auto source = [&](VertexHandle v) { return chart.source_vertex[v.idx()]; };
  if (point.is_vertex()) return {{source(point.vertex), source(point.vertex)}, 0};
  return {
      {source(chart.mesh.from_vertex_handle(point.half_edge)), source(chart.mesh.to_vertex_handle(point.half_edge))},
      point.t};
}

FlattenError wrong_path(const std::string& value, const std::string& allowed) {
  return wrong_option("path", value, allowed);
}

/// Throws an error that says why a pair of vertices is not an edge inside a piece.
[[noreturn]] void refuse(const Charts& charts, const EdgeTable& edges, int a, int b) {
  const int edge = edges.find(a, b);
  for (int j = 0; edge >= 0 && j < edges.num_sides(edge); ++j) {
    for (const Chart& chart : charts.charts) {
      const std::vector<int>& faces = chart.source_face;
      const bool is_there = std::binary_search(faces.begin(), faces.end(), edges.side(edge, j) / 3);
      if (is_there && chart.mesh.n_faces() == 0) throw *chart.error;
    }
  }
  const std::string pair = std::to_string(a) + ", " + std::to_string(b);
  if (edge < 0) throw wrong_path("through " + pair, "run along edges of the mesh, and these vertices have no edge");
  throw wrong_path("through " + pair, "run inside a piece, and this edge is on a seam or an outline");
}

void check_path(const std::vector<int>& path, int count) {
  if (path.size() < 2) throw wrong_path("too short", "have two vertices or more");
  std::set<int> passed;
  for (const int v : path) {
    const std::string value = "through vertex " + std::to_string(v);
    if (v < 0 || v >= count) throw wrong_path(value, "use the vertices of the mesh, 0 to " + std::to_string(count - 1));
    if (!passed.insert(v).second)
      throw wrong_path(value + " twice", "pass each vertex once, so straighten it in parts");
  }
}

}  // namespace

std::vector<LinePoint> straighten_path(const FlattenInput& input, const std::vector<int>& path) {
  check_mesh(input);
  const int count = static_cast<int>(input.vertices.rows());
  const EdgeTable edges(input.faces, count);
  check_seams_and_wires(input, edges);
  check_path(path, count);

  const Charts charts = cut_into_charts(input, edges);
  const InnerEdges inner(charts.charts);
  const std::set<VertexPair> wire_edges = edges_of(input.wires);
  std::vector<LinePoint> line;
  for (std::size_t i = 1; i < path.size();) {
    const InnerEdges::Side first = inner.find(path[i - 1], path[i]);
    if (!first.half_edge.is_valid()) refuse(charts, edges, path[i - 1], path[i]);
    const Chart& chart = charts.charts[first.chart];
    const WireMask lines = lines_of(chart, wire_edges);
    std::vector<VertexHandle> run{chart.mesh.from_vertex_handle(first.half_edge),
                                  chart.mesh.to_vertex_handle(first.half_edge)};
    for (++i; i < path.size() && !lines.has(run.back()); ++i) {
      const InnerEdges::Side next = inner.find(path[i - 1], path[i]);
      if (!next.half_edge.is_valid()) refuse(charts, edges, path[i - 1], path[i]);
      run.push_back(chart.mesh.to_vertex_handle(next.half_edge));
    }
    if (!line.empty()) line.pop_back();  // the last point of a run is the first point of the following run
    for (const PathPoint& point : smooth_line(chart.mesh, lines, run, Nearness::touching))
      line.push_back(in_input(chart, point));
  }
  return line;
}

}  // namespace wirewarp
