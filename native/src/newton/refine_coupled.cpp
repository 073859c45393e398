// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/refine_coupled.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "newton/next_stage.h"
#include "surface/charts/elastic_seams.h"

namespace wirewarp {
namespace {

std::optional<TargetLengths> combine_lengths(const CombinedCharts& combined, const std::vector<CoupledChart>& charts) {
  if (!charts.front().lengths) return std::nullopt;
  TargetLengths all{{}, {}, charts.front().lengths->flat_share};
  for (std::size_t c = 0; c < charts.size(); ++c) {
    for (GrainRow grain : charts[c].lengths->grains) {
      grain.a += combined.first_vertex[c];
      grain.b += combined.first_vertex[c];
      all.grains.push_back(grain);
    }
    std::vector<double> ratios = charts[c].lengths->ratio;
    ratios.resize(charts[c].chart.mesh.n_edges(), 1);
    all.ratio.insert(all.ratio.end(), ratios.begin(), ratios.end());
  }
  return all;
}

/// The starts of the charts may overlap, because the charts share no entry of the matrix.
Shape combine_starts(const CombinedCharts& combined, const std::vector<CoupledChart>& charts, const Problem& whole,
                     const std::vector<Problem>& problems, std::size_t num_grains) {
  std::size_t next_row = whole.network().edges.size();
  Shape all{Positions2(static_cast<Eigen::Index>(combined.chart.mesh.n_vertices()), 2),
            {},
            Eigen::VectorXd::Zero(static_cast<Eigen::Index>(next_row + num_grains))};
  for (std::size_t c = 0; c < charts.size(); ++c) {
    const auto& [uv, variation, multipliers] = charts[c].start;
    all.uv.middleRows(combined.first_vertex[c], uv.rows()) = uv;
    const HeldNetwork& own = problems[c].network();
    const auto multiplier = [&given = multipliers](std::size_t row) {
      const auto index = static_cast<Eigen::Index>(row);
      return index < given.size() ? given[index] : 0;
    };
    for (std::size_t e = 0; e < own.edges.size(); ++e) {
      const int there = whole.network().wire_edge_of_edge[combined.first_edge[c] + own.edges[e].edge.idx()];
      all.multipliers[there] = multiplier(e);
    }
    for (std::size_t g = 0; g < (charts[c].lengths ? charts[c].lengths->grains.size() : 0); ++g) {
      all.multipliers[static_cast<Eigen::Index>(next_row++)] = multiplier(own.edges.size() + g);
    }
  }
  return all;
}

/// Returns the largest residual of the first-order conditions, without pulls against bounds. Forces at vertices are
/// divided by the root of the area, and pulls on elastic lengths by the area.
double projected_gradient(const Problem& problem, const Stage& stage, const Shape& shape) {
  const LengthConstraints constraints = problem.constraints(stage, shape.uv);
  Positions2 gradient;
  problem.objective(stage).value_and_gradient(shape.uv, gradient);
  constraints.add_transposed(constraints.directions(shape.uv), shape.multipliers, gradient);
  double largest = gradient.cwiseAbs().maxCoeff() / std::sqrt(problem.area());
  const Eigen::VectorXd pull = constraints.elastic_lengths().transpose() * shape.multipliers / problem.area();
  for (std::size_t i = 0; i < problem.chart().wire_parts.size(); ++i) {
    const int w = constraints.elastic_of_part()[i];
    if (w >= 0 && !constraints.is_at_bound(w, shape.variation[static_cast<Eigen::Index>(i)], pull[w]))
      largest = std::max(largest, std::abs(pull[w]));
  }
  return largest;
}

}  // namespace

std::vector<Solution> refine_coupled(const std::vector<CoupledChart>& charts, double fairness, const Stage& stage,
                                     const Control& control) {
  std::vector<const Chart*> members;
  std::vector<Problem> problems;
  for (const CoupledChart& one : charts) {
    members.push_back(&one.chart);
    problems.emplace_back(one.chart, fairness);
  }
  const CombinedCharts combined = combine(members);
  Problem problem(combined.chart, fairness);
  const std::optional<TargetLengths> lengths = combine_lengths(combined, charts);
  Stage of_group = stage;
  if (lengths) of_group.lengths = &*lengths;
  const Shape start = combine_starts(combined, charts, problem, problems, lengths ? lengths->grains.size() : 0);
  const Solution whole = minimize_next(problem, of_group, start, control);
  Solution figures = whole;
  figures.shape = {};
  of_group.injectivity = Injectivity::none;
  if (charts.size() > 1) figures.projected_gradient = projected_gradient(problem, of_group, whole.shape);
  std::vector<Solution> solutions;
  for (std::size_t c = 0; c < charts.size(); ++c) {
    Solution one = figures;
    const auto num_parts = static_cast<Eigen::Index>(charts[c].chart.wire_parts.size());
    one.shape = {whole.shape.uv.middleRows(combined.first_vertex[c], charts[c].start.uv.rows()),
                 whole.shape.variation.segment(combined.first_part[c], num_parts),
                 {}};
    one.objective = problems[c].objective({stage.cloth}).value(one.shape.uv) / problems[c].area();
    solutions.push_back(std::move(one));
  }
  return solutions;
}

}  // namespace wirewarp
