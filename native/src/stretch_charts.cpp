// SPDX-License-Identifier: GPL-3.0-or-later
#include "stretch_charts.h"

#include <algorithm>
#include <map>
#include <utility>

#include "chart_errors.h"
#include "charts/seams_that_give.h"
#include "errors/sentence.h"
#include "factorization_failed.h"
#include "mesh/geometry.h"
#include "network/length_variation.h"
#include "orientation/upright_direction.h"
#include "piece_report.h"
#include "refine/refine_cloth.h"
#include "refine/refine_together.h"

namespace wirewarp {
namespace {

constexpr double kToldDifference = 0.01;  // between the sides of a seam, over their length: what a seam eases in

/// One figure per edge of a chart.
using PerEdge = std::vector<double>;

/// The diagonal of S⁻¹.
Eigen::RowVector2d flat_share(const Cloth& cloth) { return {1 / (1 + cloth.stretch[0]), 1 / (1 + cloth.stretch[1])}; }

/// Edges whose flat length follows the stretch: of the outline and of wires whose length is held, without an ease.
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

/// L / l by the direction that each edge has in the layout; 1 where the stretch does not count.
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

/// The same for all sides of an outline's edge: their mean.
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

/// Of a side of a seam, by the ratios of its edges.
double length_of_side(const Chart& chart, const HalfEdgeChain& chain, const PerEdge& ratios) {
  double length = 0;
  for (const HalfedgeHandle h : chain) length += ratios[chart.mesh.edge_handle(h).idx()] * edge_length(chart.mesh, h);
  return length;
}

/// Warnings for the charts beside seams whose sides differ. ratios: by direction, empty without a layout.
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
    if (*most - *least <= kToldDifference * *most) continue;
    const std::string warning = "The cloth's stretch would make the sides of the seam along " +
                                name_elements("edge", seam.edges) + " " + percent(1 - *most / length_3d) + " to " +
                                percent(1 - *least / length_3d) +
                                " shorter, as they run in different directions: both are cut by the mean.";
    for (const Seam::Side& side : seam.sides) {
      std::vector<std::string>& own = warnings[side.chart];
      if (own.empty() || own.back() != warning) own.push_back(warning);
    }
  }
  return warnings;
}

void ask_for(const PerEdge& ratios, Chart& chart) {
  chart.length_ratio.resize(chart.mesh.n_edges(), 1);
  for (std::size_t e = 0; e < ratios.size(); ++e) chart.length_ratio[e] *= ratios[e];
}

/// shape: in the plane of the stretched cloth. chart: asks for the flat lengths.
void take_shape(const RefinedShape& shape, const Cloth& cloth, bool was_stopped, const Chart& chart,
                SolvedChart& solved) {
  report_next_refinement(shape, was_stopped, solved.report);
  solved.report.objective *= flat_share(cloth).prod();  // per flat area
  solved.uv = shape.uv * flat_share(cloth).asDiagonal();
  solved.network = build_wire_network(chart);
  Eigen::VectorXd variation = shape.variation;
  const Eigen::VectorXd flat = length_variation(chart, solved.uv);
  for (Eigen::Index i = 0; i < variation.size(); ++i) {
    if (chart.wire_parts[i].kind == WireKind::super_elastic) variation[i] = flat[i];
  }
  solved.variation = variations_of(chart, variation);
}

void lose_layout(FlattenError error, Termination termination, SolvedChart& solved) {
  solved.uv.resize(0, 2);
  solved.network.reset();
  solved.proposed_seams.clear();
  solved.report.termination = termination;
  solved.error = std::move(error);
}

FlattenError no_stretched_shape(const Chart& chart) {
  return FlattenError(ErrorCode::infeasible_lengths,
                      "No flat shape of " + name_piece(chart.source_face) +
                          " was found that has the lengths which the cloth's stretch asks for: take less stretch, or "
                          "mark another seam.",
                      {{}, {}, chart.source_face});
}

/// Charts that seams which give hold together, or one.
class GroupToStretch {
 public:
  GroupToStretch(const std::vector<int>& group, const std::vector<PerEdge>& ratios, const InternalOptions& options,
                 std::vector<Chart>& charts, std::vector<SolvedChart>& solved)
      : options_(options), charts_(charts), solved_(solved) {
    for (const int c : group) {
      if (ratios[c].empty()) continue;
      members_.push_back(c);
      const Positions2& uv = solved[c].uv;
      copies_.push_back(charts[c]);
      cloths_.push_back({*options.cloth, {hold_direction(upright_pair(charts[c], uv, options), uv)}, ratios[c]});
      starts_.emplace_back(uv);
    }
  }

  void stretch(const StopToken& stop) {
    if (members_.empty()) return;
    std::optional<JoinedShapes> joined;
    try {
      RefineBudget budget(options_.max_factorizations);
      stop.check();
      joined = refine_together(copies_, options_.fairness, cloths_, starts_, {budget, stop, Injectivity::local});
      if (!joined->shapes.front().is_exact) joined.reset();
    } catch (const Stopped&) {
      for (const int c : members_) lose_layout(cancelled(), Termination::cancelled, solved_[c]);
      return;
    } catch (const FactorizationFailed&) {
      joined.reset();  // no shape is found
    }
    for (std::size_t k = 0; k < members_.size(); ++k) {
      const int c = members_[k];
      if (!joined) {
        lose_layout(no_stretched_shape(charts_[c]), Termination::failed, solved_[c]);
        continue;
      }
      ask_for(cloths_[k].flat_ratio, charts_[c]);
      take_shape(joined->shapes[k], *options_.cloth, stop.is_stopped(), charts_[c], solved_[c]);
    }
  }

 private:
  const InternalOptions& options_;
  std::vector<Chart>& charts_;
  std::vector<SolvedChart>& solved_;
  std::vector<int> members_;  // with a layout
  std::vector<Chart> copies_;
  std::vector<ClothOnChart> cloths_;
  std::vector<RefinementStart> starts_;
};

}  // namespace

void stretch_charts(Charts& charts, const InternalOptions& options, const StopToken& stop,
                    std::vector<SolvedChart>& solved) {
  std::vector<PerEdge> ratios(charts.charts.size());
  for (std::size_t c = 0; c < charts.charts.size(); ++c) {
    if (solved[c].uv.rows() > 0) ratios[c] = ratios_by_direction(charts.charts[c], solved[c].uv, *options.cloth);
  }
  const std::vector<std::vector<std::string>> warnings = warn_of_sides(charts, ratios);
  share_among_sides(charts.charts, ratios);
  for (const std::vector<int>& group : group_by_seams_that_give(charts.charts)) {
    GroupToStretch(group, ratios, options, charts.charts, solved).stretch(stop);
  }
  for (std::size_t c = 0; c < warnings.size(); ++c) {
    std::vector<std::string>& own = solved[c].report.warnings;
    own.insert(own.end(), warnings[c].begin(), warnings[c].end());
  }
}

}  // namespace wirewarp
