// SPDX-License-Identifier: GPL-3.0-or-later
#include "stretch_charts.h"

#include <algorithm>
#include <map>
#include <utility>

#include "attempt.h"
#include "chart_errors.h"
#include "charts/elastic_seams.h"
#include "couple_charts.h"
#include "errors/sentence.h"
#include "mesh/geometry.h"
#include "network/length_variation.h"
#include "piece_report.h"
#include "refine/injective_shape.h"
#include "refine/refine_cloth.h"
#include "refine/refine_coupled.h"

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

void lose_layout(FlattenError error, Termination termination, SolvedChart& solved) {
  solved.uv.resize(0, 2);
  solved.network.reset();
  solved.proposed_seams.clear();
  solved.report.termination = termination;
  solved.error = std::move(error);
}

/// A layout in the plane of the stretched cloth becomes the flat one. chart: asks for its lengths.
void lie_flat(const Chart& chart, const Cloth& cloth, SolvedChart& solved) {
  solved.report.objective *= flat_share(cloth).prod();  // per flat area
  solved.uv = solved.uv * flat_share(cloth).asDiagonal();
  solved.network = build_wire_network(chart);
  const std::vector<double> flat = variations_of(chart, length_variation(chart, solved.uv));
  for (std::size_t i = 0; i < flat.size(); ++i) {
    if (chart.wire_parts[i].kind == WireKind::super_elastic) solved.variation[i] = flat[i];
  }
}

/// A coupled group, or one chart; with layouts in which no triangle is flipped.
class GroupToStretch {
 public:
  GroupToStretch(std::vector<int> members, const std::vector<PerEdge>& ratios, const Run& run,
                 std::vector<Chart>& charts, std::vector<SolvedChart>& solved)
      : members_(std::move(members)), run_(run), charts_(charts), solved_(solved) {
    for (const int c : members_) {
      unstretched_.push_back(solved[c]);
      cloths_.push_back({*run.options.cloth, {hold_upright(charts[c], solved[c].uv, run.options)}, ratios[c]});
      const std::vector<WirePart>& parts = charts[c].wire_parts;
      gives_ = gives_ || std::any_of(parts.begin(), parts.end(), gives_on_boundary);
    }
  }

  void stretch(const StopToken& stop) {
    std::vector<CoupledChart> together;
    for (std::size_t k = 0; k < members_.size(); ++k) together.push_back(coupled(k, charts_[members_[k]], gives_));
    const CouplingOutcome outcome = couple(together, 0, stop);
    for (std::size_t k = 0; k < members_.size(); ++k) {
      if (outcome.is_coupled) {
        finish(k, outcome.is_folded[k] != 0, stop);
      } else {
        stretch_with_fixed_seams(k, outcome.ran_out, stop);
      }
    }
  }

 private:
  CoupledChart coupled(std::size_t k, const Chart& chart, bool may_be_nominal) {
    const int most = solved_[members_[k]].report.factorizations + run_.options.max_factorizations;
    return {chart, solved_[members_[k]], may_be_nominal, cloths_[k], most};
  }

  /// first: of the members.
  CouplingOutcome couple(const std::vector<CoupledChart>& charts, std::size_t first, const StopToken& stop) {
    if (!stop.may_go_on()) return {false, false, {}};
    const auto alone = [&](std::size_t index, const Chart& fixed, RefineBudget& budget, const StopToken& in_shape) {
      return refine_apart(first + index, fixed, budget, in_shape);
    };
    return couple_charts(charts, run_.options, alone, stop);
  }

  /// Starts from the unstretched layout and never overlaps on the way.
  std::optional<RefineResult> refine_apart(std::size_t k, const Chart& fixed, RefineBudget& budget,
                                           const StopToken& stop) const {
    if (injectivity_of(fixed, unstretched_[k].uv) != Injectivity::global) return std::nullopt;
    RefineResult refined;
    refined.shape = refine_coupled({fixed}, run_.options.fairness, {cloths_[k]}, {RefinementStart(unstretched_[k].uv)},
                                   {budget, stop, Injectivity::global})
                        .shapes.front();
    if (!refined.shape.is_exact() || injectivity_of(fixed, refined.shape.uv) != Injectivity::global)
      return std::nullopt;
    refined.start = unstretched_[k].report.start.c_str();
    refined.shape.iterations += unstretched_[k].report.outer_iterations;
    refined.factorizations = budget.spent();
    return refined;
  }

  /// With its elastic seams at h = ease. ran_out: so did the coupled group.
  void stretch_with_fixed_seams(std::size_t k, bool ran_out, const StopToken& stop) {
    const int c = members_[k];
    const Chart fixed = with_fixed_seams(charts_[c]);
    CouplingOutcome outcome{false, false, {}};
    if (gives_) outcome = couple({coupled(k, fixed, false)}, k, stop);
    if (outcome.is_coupled) {
      finish(k, outcome.is_folded.front() != 0, stop);
      if (solved_[c].report.termination != Termination::cancelled) report_fixed_seams(solved_[c].report);
    } else if (stop.is_stopped()) {
      lose_layout(cancelled(), Termination::cancelled, solved_[c]);
    } else if (injectivity_of(charts_[c], unstretched_[k].uv) == Injectivity::global) {
      explain_infeasible(k, ran_out || outcome.ran_out, stop);
    }  // else its error is that it overlaps itself, stretched or not
  }

  /// The proposed seams are judged at the lengths that the stretch sets: others would not help.
  void explain_infeasible(std::size_t k, bool ran_out, const StopToken& stop) {
    const int c = members_[k];
    Chart stretched = charts_[c];
    ask_for(cloths_[k].flat_ratio, stretched);
    const std::vector<VertexPair> seams = attempt([&] { return propose_seams(stretched, run_, stop); });
    if (stop.is_stopped()) {
      lose_layout(cancelled(), Termination::cancelled, solved_[c]);
    } else {
      lose_layout(infeasible_stretch(stretched, run_.options, seams, ran_out), Termination::failed, solved_[c]);
    }
  }

  void finish(std::size_t k, bool is_folded, const StopToken& stop) {
    SolvedChart& solved = solved_[members_[k]];
    Chart& chart = charts_[members_[k]];
    ask_for(cloths_[k].flat_ratio, chart);
    if (is_folded) propose_seams_for_layout(chart, run_, stop, solved);
    lie_flat(chart, *run_.options.cloth, solved);
  }

  std::vector<int> members_;
  const Run& run_;
  std::vector<Chart>& charts_;
  std::vector<SolvedChart>& solved_;
  std::vector<SolvedChart> unstretched_;  // without the stretch, per member
  std::vector<ClothOnChart> cloths_;      // per member
  bool gives_ = false;                    // it has elastic seams or outlines
};

}  // namespace

void stretch_charts(Charts& charts, const Run& run, ChartsProgress& progress, std::vector<SolvedChart>& solved) {
  std::vector<PerEdge> ratios(charts.charts.size());
  for (std::size_t c = 0; c < charts.charts.size(); ++c) {
    if (solved[c].uv.rows() > 0) ratios[c] = ratios_by_direction(charts.charts[c], solved[c].uv, *run.options.cloth);
  }
  const std::vector<std::vector<std::string>> warnings = warn_of_sides(charts, ratios);
  share_among_sides(charts.charts, ratios);
  const std::vector<std::vector<int>> groups = group_by_elastic_seams(charts.charts);
  progress.run(groups.size(), [&](std::size_t g) {
    const std::vector<int>& group = groups[g];
    std::vector<int> members;
    for (const int c : group) {
      const bool has_layout = solved[c].uv.rows() > 0;
      if (has_layout && injectivity_of(charts.charts[c], solved[c].uv) != Injectivity::none) members.push_back(c);
    }
    const StopToken stop = progress.stop_token(static_cast<std::size_t>(group.front())).in("shape");
    if (!members.empty()) GroupToStretch(std::move(members), ratios, run, charts.charts, solved).stretch(stop);
    for (const int c : group) progress.finish(static_cast<std::size_t>(c));
  });
  for (std::size_t c = 0; c < warnings.size(); ++c) {
    std::vector<std::string>& own = solved[c].report.warnings;
    own.insert(own.end(), warnings[c].begin(), warnings[c].end());
  }
}

}  // namespace wirewarp
