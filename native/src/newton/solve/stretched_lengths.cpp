// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/solve/stretched_lengths.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "base/sentence.h"
#include "energy/target_lengths.h"
#include "surface/mesh/geometry.h"

namespace wirewarp {
namespace {

// Largest difference between the sides of a seam, divided by the longer side, that can be eased in. Larger differences
// are reported.
constexpr double kReportedDifference = 0.01;

/// Returns the edges whose flat lengths depend on the stretch: edges without an ease that belong to the outline, or to
/// fixed or elastic wires.
std::vector<char> find_stretched_edges(const Chart& chart) {
  std::vector<char> is_stretched(chart.mesh.n_edges(), 0);
  for (const HalfEdgeChain& loop : chart.boundary_loops) {
    for (const HalfedgeHandle h : loop) is_stretched[chart.mesh.edge_handle(h).idx()] = 1;
  }
  for (const WirePart& part : chart.wire_parts) {
    const char is_held = part.kind != WireKind::super_elastic && part.ease == 0;
    for (const HalfedgeHandle h : part.half_edges) is_stretched[chart.mesh.edge_handle(h).idx()] = is_held;
  }
  return is_stretched;
}

/// Returns L / l of each edge. This ratio depends on the direction of the edge in the layout. It is 1 if the flat
/// length does not depend on the stretch.
PerEdge ratios_by_direction(const Chart& chart, const Positions2& uv, const Cloth& cloth) {
  const Eigen::RowVector2d share = flat_share(cloth);
  const std::vector<char> is_stretched = find_stretched_edges(chart);
  PerEdge ratios(chart.mesh.n_edges(), 1);
  for (const EdgeHandle e : chart.mesh.edges()) {
    const HalfedgeHandle h = chart.mesh.halfedge_handle(e, 0);
    const Eigen::RowVector2d d =
        uv.row(chart.mesh.to_vertex_handle(h).idx()) - uv.row(chart.mesh.from_vertex_handle(h).idx());
    if (is_stretched[e.idx()] != 0 && d.norm() > 0) ratios[e.idx()] = d.cwiseProduct(share).norm() / d.norm();
  }
  return ratios;
}

/// Replaces the ratios of all sides of an edge with their mean.
void share_among_sides(const std::vector<Chart>& charts, std::vector<PerEdge>& ratios) {
  struct Mean {
    double sum = 0;
    int count = 0;
  };
  std::map<VertexPair, Mean> means;
  const auto for_each_side = [&](const auto& visit) {
    for (std::size_t c = 0; c < charts.size(); ++c) {
      if (ratios[c].empty()) continue;
      for (const HalfEdgeChain& loop : charts[c].boundary_loops) {
        for (const HalfedgeHandle h : loop) {
          visit(means[source_edge(charts[c], h)], ratios[c][charts[c].mesh.edge_handle(h).idx()]);
        }
      }
    }
  };
  for_each_side([](Mean& mean, double ratio) { mean = {mean.sum + ratio, mean.count + 1}; });
  for_each_side([](const Mean& mean, double& ratio) { ratio = mean.sum / mean.count; });
}

double length_of_side(const Chart& chart, const HalfEdgeChain& chain, const PerEdge& ratios) {
  double length = 0;
  for (const HalfedgeHandle h : chain) length += ratios[chart.mesh.edge_handle(h).idx()] * edge_length(chart.mesh, h);
  return length;
}

/// Returns, for each chart, warnings about seams whose sides would have different lengths. ratios: from the directions
/// of edges, before the sides share their mean; empty for a chart without a layout.
std::vector<std::vector<std::string>> warn_of_sides(const Charts& charts, const std::vector<PerEdge>& ratios) {
  std::vector<std::vector<std::string>> warnings(charts.charts.size());
  for (const Seam& seam : charts.seams) {
    std::vector<double> lengths;
    double length_3d = 0;
    for (const Seam::Side& side : seam.sides) {
      if (side.boundary_chain < 0 || ratios[side.chart].empty()) continue;
      const Chart& chart = charts.charts[side.chart];
      const HalfEdgeChain& chain = chart.boundary_chains[side.boundary_chain].half_edges;
      lengths.push_back(length_of_side(chart, chain, ratios[side.chart]));
      length_3d = length_of(chart.mesh, chain);
    }
    if (lengths.size() < 2) continue;
    const auto [least, most] = std::minmax_element(lengths.begin(), lengths.end());
    if (*most - *least <= kReportedDifference * *most) continue;
    const std::string warning = "The sides of the seam along " + name_elements("edge", seam.edges) +
                                " run in different directions, so the fabric's stretch would make them " +
                                percent(1 - *most / length_3d) + " to " + percent(1 - *least / length_3d) +
                                " shorter. All sides are cut with the mean length.";
    for (const Seam::Side& side : seam.sides) {
      std::vector<std::string>& own = warnings[side.chart];
      if (own.empty() || own.back() != warning) own.push_back(warning);
    }
  }
  return warnings;
}

}  // namespace

bool is_stretched(const Options& options) {
  return options.cloth && options.cloth->stretch != std::array<double, 2>{0, 0};
}

StretchedLengths find_stretched_lengths(const Charts& charts, const std::vector<SolvedChart>& solved,
                                        const Cloth& cloth) {
  StretchedLengths found;
  found.ratios.resize(charts.charts.size());
  for (std::size_t c = 0; c < charts.charts.size(); ++c) {
    if (solved[c].uv.rows() > 0) found.ratios[c] = ratios_by_direction(charts.charts[c], solved[c].uv, cloth);
  }
  found.warnings = warn_of_sides(charts, found.ratios);
  share_among_sides(charts.charts, found.ratios);
  return found;
}

}  // namespace wirewarp
