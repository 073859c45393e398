// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/coarsen/prolong_wires.h"

#include <array>
#include <cmath>
#include <complex>
#include <numeric>

#include "base/planar.h"

namespace wirewarp {
namespace {

/// Compares the angles between runs that meet at a coarse wire vertex with the angles on the surface.
class WireTurns {
 public:
  WireTurns(const CoarseChart& coarse, const Positions2& uv);

  /// Returns the angles by which a run must be bent at its first and last vertex. After this, all runs that meet at a
  /// vertex are rotated there by the same angle, compared with the surface.
  const std::array<double, 2>& at_ends(int run) const { return turns_[run]; }

 private:
  double heading(WireHalfEdge h) const { return chords_[h.edge] + (h.reversed ? kPi : 0); }
  void turn_around(WireHalfEdge first);

  const HeldNetwork& network_;
  std::vector<double> chords_;  // headings of the chords, one per run
  std::vector<int> nodes_;      // per half-edge: node at which it arrives
  std::vector<char> is_seen_;
  std::vector<std::array<double, 2>> turns_;
};

WireTurns::WireTurns(const CoarseChart& coarse, const Positions2& uv)
    : network_(coarse.network),
      nodes_(nodes_at_arrival(coarse.network)),
      is_seen_(nodes_.size(), 0),
      turns_(coarse.runs.size(), {0, 0}) {
  const HalfEdgeMesh& mesh = coarse.chart.mesh;
  for (const WireEdge& edge : network_.edges) {
    const HalfedgeHandle h = mesh.halfedge_handle(edge.edge, 0);
    const Eigen::RowVector2d d = uv.row(mesh.to_vertex_handle(h).idx()) - uv.row(mesh.from_vertex_handle(h).idx());
    chords_.push_back(std::atan2(d.y(), d.x()));
  }
  std::vector<char> follows_a_node(nodes_.size(), 0);
  for (const WireNode& node : network_.nodes) follows_a_node[place_of(node.out)] = 1;
  // The first pass starts on the boundary, at the half-edges where the nodes around a vertex begin. The second pass
  // adds all other vertices.
  for (const bool everywhere : {false, true}) {
    for (int e = 0; e < static_cast<int>(chords_.size()); ++e) {
      for (const WireHalfEdge h : {WireHalfEdge{e, false}, WireHalfEdge{e, true}}) {
        if (everywhere || !follows_a_node[place_of(opposite(h))]) turn_around(h);
      }
    }
  }
}

/// Sets the turns of the runs around the vertex at which `first` arrives. Each run turns by the mean rotation of all
/// runs against the surface, minus its own rotation.
void WireTurns::turn_around(WireHalfEdge first) {
  std::vector<WireHalfEdge> runs;
  std::vector<double> rotations{0};
  for (WireHalfEdge h = first; !is_seen_[place_of(h)];) {
    is_seen_[place_of(h)] = 1;
    runs.push_back(h);
    const int n = nodes_[place_of(h)];
    if (n == -1) break;
    const WireNode& node = network_.nodes[n];
    const double turned = heading(node.out) - heading(node.in) - (kPi - node.surface_angle);
    rotations.push_back(rotations.back() + std::remainder(turned, 2 * kPi));
    h = opposite(node.out);
  }
  if (runs.empty()) return;
  const auto count = static_cast<double>(runs.size());
  // The flat angles around an inner vertex may have another sum than on the surface. All angles share the difference.
  const double lack = rotations.size() > runs.size() ? rotations.back() / count : 0;
  rotations.resize(runs.size());
  for (std::size_t i = 0; i < runs.size(); ++i) rotations[i] -= static_cast<double>(i) * lack;
  const double mean = std::accumulate(rotations.begin(), rotations.end(), 0.0) / count;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    turns_[runs[i].edge][runs[i].reversed ? 0 : 1] = mean - rotations[i];
  }
}

}  // namespace

void prolong_wires(const Chart& chart, const HeldNetwork& network, const CoarseChart& coarse,
                   const Positions2& coarse_uv, Positions2& uv) {
  const WireTurns turns(coarse, coarse_uv);
  for (int e = 0; e < static_cast<int>(coarse.runs.size()); ++e) {
    const WireRun& run = coarse.runs[e];
    const HalfedgeHandle h = coarse.chart.mesh.halfedge_handle(coarse.network.edges[e].edge, 0);
    using Complex = std::complex<double>;
    const auto position = [&](VertexHandle v) { return Complex(coarse_uv(v.idx(), 0), coarse_uv(v.idx(), 1)); };
    const Complex begin = position(coarse.chart.mesh.from_vertex_handle(h));
    const Complex chord = position(coarse.chart.mesh.to_vertex_handle(h)) - begin;
    std::vector<Complex> laid{0};
    for (std::size_t i = 0; i < run.half_edges.size(); ++i) {
      const int fine = run.half_edges[i].edge;
      const double s = (coarse.wire_places[fine].from + coarse.wire_places[fine].to) / 2;
      // This quadratic polynomial has the turns of the ends at s = 0 and s = 1. Its mean is 0, so the chord keeps its
      // heading.
      const double turn = (1 - s) * (1 - 3 * s) * turns.at_ends(e)[0] + s * (3 * s - 2) * turns.at_ends(e)[1];
      laid.push_back(laid.back() + std::polar(network.edges[fine].length, run.headings[i] + turn));
    }
    for (std::size_t i = 1; i < run.half_edges.size(); ++i) {
      const Complex p = begin + chord * laid[i] / laid.back();
      const WireHalfEdge w = run.half_edges[i];
      const int v = chart.mesh.from_vertex_handle(half_edge(chart, network, w)).idx();
      uv.row(v) << p.real(), p.imag();
    }
  }
}

}  // namespace wirewarp
