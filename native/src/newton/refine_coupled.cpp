// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/refine_coupled.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/attempt.h"
#include "energy/length_constraints.h"
#include "newton/injective_start.h"
#include "newton/shut_slits.h"
#include "surface/charts/elastic_seams.h"
#include "surface/mesh/geometry.h"

namespace wirewarp {
namespace {

/// The cloths of all charts as that of the combined one.
std::optional<ClothOnChart> combine_cloths(const CombinedCharts& combined, const std::vector<Chart>& charts,
                                           const std::vector<ClothOnChart>& cloths) {
  if (cloths.empty()) return std::nullopt;
  ClothOnChart all{cloths.front().cloth, {}, {}};
  for (std::size_t c = 0; c < charts.size(); ++c) {
    for (GrainRow grain : cloths[c].grains) {
      grain.a += combined.first_vertex[c];
      grain.b += combined.first_vertex[c];
      all.grains.push_back(grain);
    }
    std::vector<double> ratios = cloths[c].flat_ratio;
    ratios.resize(charts[c].mesh.n_edges(), 1);
    all.flat_ratio.insert(all.flat_ratio.end(), ratios.begin(), ratios.end());
  }
  return all;
}

/// The starts of all charts, each where it is: charts have no entry of the matrix in common.
RefinementStart combine_starts(const CombinedCharts& combined, const HeldNetwork& network,
                               const std::vector<HeldNetwork>& networks, const std::vector<ClothOnChart>& cloths,
                               const std::vector<RefinementStart>& starts) {
  std::size_t num_rows = network.edges.size(), next_row = num_rows;
  for (const ClothOnChart& cloth : cloths) num_rows += cloth.grains.size();
  RefinementStart all{Positions2(static_cast<Eigen::Index>(combined.chart.mesh.n_vertices()), 2),
                      Eigen::VectorXd::Zero(static_cast<Eigen::Index>(num_rows))};
  for (std::size_t c = 0; c < starts.size(); ++c) {
    all.uv.middleRows(combined.first_vertex[c], starts[c].uv.rows()) = starts[c].uv;
    const HeldNetwork& own = networks[c];
    const Eigen::VectorXd& multipliers = starts[c].multipliers;
    const auto multiplier = [&](std::size_t row) {
      const auto index = static_cast<Eigen::Index>(row);
      return index < multipliers.size() ? multipliers[index] : 0;
    };
    for (std::size_t e = 0; e < own.edges.size(); ++e) {
      const int there = network.wire_edge_of_edge[combined.first_edge[c] + own.edges[e].edge.idx()];
      all.multipliers[there] = multiplier(e);
    }
    for (std::size_t g = 0; g < (cloths.empty() ? 0 : cloths[c].grains.size()); ++g) {
      all.multipliers[static_cast<Eigen::Index>(next_row++)] = multiplier(own.edges.size() + g);
    }
  }
  return all;
}

/// What is left of the first-order conditions.
double projected_gradient(const RefineTask& task, const RefinedShape& shape) {
  const LengthConstraints constraints(task.chart, task.network, task.cloth, shape.uv);
  const double area = surface_area(task.chart.mesh);
  Positions2 gradient;
  FairShapeError(task).value_and_gradient(shape.uv, gradient);
  constraints.add_transposed(constraints.directions(shape.uv), shape.multipliers, gradient);
  double largest = gradient.cwiseAbs().maxCoeff() / std::sqrt(area);
  const Eigen::VectorXd pull = constraints.elastic_lengths().transpose() * shape.multipliers / area;
  for (std::size_t i = 0; i < task.chart.wire_parts.size(); ++i) {
    const int w = constraints.elastic_of_part()[i];
    if (w < 0) continue;
    const double h = shape.variation[static_cast<Eigen::Index>(i)], most = constraints.tolerance()[w];
    const bool is_held = pull[w] > 0 ? h >= most : h <= -most;
    if (!is_held) largest = std::max(largest, std::abs(pull[w]));
  }
  return largest;
}

/// Where the start is too far from exact lengths for one step, by the method of multipliers from there.
RefinedShape refine_near(const RefineTask& task, const RefinementStart& start, bool is_one,
                         const RefinementLimits& limits) {
  const int spent_before = limits.budget.spent();
  RefinedShape shape = is_one ? refine_with_shut_slits(task, start, limits) : refine_shape(task, start, limits);
  const bool may_not_turn_over = limits.injectivity != Injectivity::none;
  if (!shape.is_exact() && may_not_turn_over && FairShapeError(task).count_flips(start.uv) == 0) {
    const std::optional<RefinementStart> exact = attempt([&] { return injective_start(task, start.uv, limits); });
    if (exact) shape = refine_shape(task, *exact, limits);
  }
  shape.factorizations = limits.budget.spent() - spent_before;
  return shape;
}

}  // namespace

CoupledShapes refine_coupled(const std::vector<Chart>& charts, double fairness, const std::vector<ClothOnChart>& cloths,
                             const std::vector<RefinementStart>& starts, const RefinementLimits& limits) {
  const CombinedCharts combined = combine(charts);
  const HeldNetwork network = build_held_network(combined.chart);
  std::vector<HeldNetwork> networks;
  for (const Chart& chart : charts) networks.push_back(build_held_network(chart));
  const std::optional<ClothOnChart> cloth = combine_cloths(combined, charts, cloths);
  const RefineTask task{combined.chart, network, fairness, cloth ? &*cloth : nullptr};
  const RefinementStart start = combine_starts(combined, network, networks, cloths, starts);
  const RefinedShape whole = refine_near(task, start, charts.size() == 1, limits);
  CoupledShapes coupled;
  coupled.projected_gradient = projected_gradient(task, whole);
  for (std::size_t c = 0; c < charts.size(); ++c) {
    RefinedShape shape = whole;
    shape.multipliers.resize(0);
    shape.uv = whole.uv.middleRows(combined.first_vertex[c], starts[c].uv.rows());
    shape.variation =
        whole.variation.segment(combined.first_part[c], static_cast<Eigen::Index>(charts[c].wire_parts.size()));
    const RefineTask alone{charts[c], networks[c], fairness, cloth ? &cloths[c] : nullptr};
    shape.objective = FairShapeError(alone).value(shape.uv) / surface_area(charts[c].mesh);
    coupled.shapes.push_back(std::move(shape));
  }
  return coupled;
}

}  // namespace wirewarp
