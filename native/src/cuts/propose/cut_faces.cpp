// SPDX-License-Identifier: GPL-3.0-or-later
#include "cuts/propose/cut_faces.h"

#include <algorithm>
#include <utility>

#include "surface/charts/cut_into_charts.h"

namespace wirewarp {
namespace {

/// Consecutive edges of a wire.
struct WireRun {
  int wire;   // index in the whole input
  int begin;  // index of the run's first edge in the wire
};

/// Some faces of an input as a separate input, which keeps the order of vertices and faces.
class PartOfInput {
 public:
  PartOfInput(const FlattenInput& whole, const std::vector<int>& faces, const std::vector<VertexPair>& seams)
      : whole_(whole), faces_(faces) {
    take_faces();
    edges_.emplace(part_.faces, static_cast<int>(vertices_.size()));
    part_.seams = as_pairs(seams).unaryExpr([&](int v) { return place_of(v); });
    for (std::size_t w = 0; w < whole.wires.size(); ++w) take_wire(static_cast<int>(w));
    for (const Ease& ease : whole.eases) take_ease(ease);
  }

  /// fans: of the whole input. If a chart meets itself at a vertex, other faces may connect its corners there.
  Charts cut(const std::vector<int>& fans, const StopToken& stop) const {
    std::vector<int> own_fans;
    for (const int f : faces_) own_fans.insert(own_fans.end(), fans.begin() + 3 * f, fans.begin() + 3 * f + 3);
    Charts charts = cut_into_charts(part_, *edges_, stop, own_fans);
    for (Chart& chart : charts.charts) {
      for (int& v : chart.source_vertex) v = vertices_[v];
      for (int& f : chart.source_face) f = faces_[f];
      for (WirePart& part : chart.wire_parts) {
        const WireRun& run = runs_[part.wire_index];
        part.wire_index = run.wire;
        part.part += run.begin;
      }
    }
    for (Seam& seam : charts.seams) {
      for (VertexPair& ends : seam.edges) ends = {vertices_[ends[0]], vertices_[ends[1]]};
    }
    charts.is_boundary_wire.assign(whole_.wires.size(), 0);
    return charts;
  }

 private:
  /// Returns the index of a vertex in the part, or -1 if none of the faces has it.
  int place_of(int vertex) const {
    const auto found = std::lower_bound(vertices_.begin(), vertices_.end(), vertex);
    return found != vertices_.end() && *found == vertex ? static_cast<int>(found - vertices_.begin()) : -1;
  }

  bool has_edge(int a, int b) const {
    const int from = place_of(a), to = place_of(b);
    return from >= 0 && to >= 0 && edges_->find(from, to) >= 0;
  }

  void take_faces() {
    for (const int f : faces_) {
      for (const int v : whole_.faces.row(f)) vertices_.push_back(v);
    }
    std::sort(vertices_.begin(), vertices_.end());
    vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
    part_.vertices = whole_.vertices(vertices_, Eigen::all);
    part_.faces = whole_.faces(faces_, Eigen::all).unaryExpr([&](int v) { return place_of(v); });
  }

  /// Adds each run of the wire's edges that is in the part. A run of a closed wire may pass the vertex at which the
  /// wire's list starts.
  void take_wire(int index) {
    const Wire& wire = whole_.wires[index];
    const int count = static_cast<int>(wire.vertices.size()) - 1;
    std::vector<char> is_taken;
    for (int i = 0; i < count; ++i) is_taken.push_back(has_edge(wire.vertices[i], wire.vertices[i + 1]) ? 1 : 0);
    const auto gap = std::find(is_taken.begin(), is_taken.end(), 0);
    const bool is_closed = wire.vertices.front() == wire.vertices.back();
    const int first = is_closed && gap != is_taken.end() ? static_cast<int>(gap - is_taken.begin()) : 0;
    bool goes_on = false;
    for (int k = 0; k < count; ++k) {
      const int i = (first + k) % count;
      if (is_taken[i] != 0 && !goes_on) {
        runs_.push_back({index, i});
        part_.wires.push_back({{place_of(wire.vertices[i])}, wire.tolerance, wire.name, wire.ease});
      }
      goes_on = is_taken[i] != 0;
      if (goes_on) part_.wires.back().vertices.push_back(place_of(wire.vertices[i + 1]));
    }
  }

  void take_ease(const Ease& ease) {
    Ease own{VertexPairs(ease.half_edges.rows(), 2), ease.ratio};
    Eigen::Index count = 0;
    for (const auto& ends : ease.half_edges.rowwise()) {
      if (has_edge(ends[0], ends[1])) own.half_edges.row(count++) << place_of(ends[0]), place_of(ends[1]);
    }
    own.half_edges.conservativeResize(count, 2);
    part_.eases.push_back(std::move(own));
  }

  const FlattenInput& whole_;
  const std::vector<int>& faces_;
  std::vector<int> vertices_;  // vertex of the whole input for each vertex of the part, sorted
  FlattenInput part_;
  std::optional<EdgeTable> edges_;
  std::vector<WireRun> runs_;  // one per wire of the part
};

}  // namespace

Charts cut_faces(const FlattenInput& input, const std::vector<int>& fans, const std::vector<int>& faces,
                 const std::vector<VertexPair>& seams, const StopToken& stop) {
  return PartOfInput(input, faces, seams).cut(fans, stop);
}

}  // namespace wirewarp
