// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/sewn_problem.h"

#include <stdexcept>
#include <utility>

#include "newton/minimize.h"

namespace wirewarp {

SewnProblem::SewnProblem(const Problem& open, const Stage& stage, SewnChart sewn)
    : open_(open), stage_(stage), sewn_(std::move(sewn)), problem_(sewn_.chart, open.fairness()) {
  const HeldNetwork &network = problem_.network(), &open_network = open.network();
  const HalfEdgeMesh& mesh = sewn_.chart.mesh;
  for (const WireEdge& edge : open_network.edges) {
    const HalfedgeHandle there = sewn_half_edge(open.chart(), sewn_, open.chart().mesh.halfedge_handle(edge.edge, 0));
    const int sewn_edge = there.is_valid() ? network.wire_edge_of_edge[mesh.edge_handle(there).idx()] : -1;
    if (sewn_edge < 0) throw std::logic_error("an edge of a wire lost its wire when slits were sewn");
    row_.push_back(sewn_edge);
  }
  num_rows_ = static_cast<int>(network.edges.size());
  if (!stage.lengths) return;
  lengths_ = *stage.lengths;
  if (!lengths_->ratio.empty()) {
    lengths_->ratio.assign(mesh.n_edges(), 1);
    for (std::size_t e = 0; e < open_network.edges.size(); ++e) {
      lengths_->ratio[network.edges[row_[e]].edge.idx()] = stage.lengths->ratio[open_network.edges[e].edge.idx()];
    }
  }
  for (GrainRow& grain : lengths_->grains) {
    grain.a = sewn_.vertex[grain.a];
    grain.b = sewn_.vertex[grain.b];
    row_.push_back(num_rows_++);
  }
}

Solution SewnProblem::minimize(const Shape& start, const Control& control) const {
  const Stage stage{stage_.cloth, lengths_ ? &*lengths_ : nullptr, stage_.injectivity, stage_.target};
  Shape sewn{
      Positions2(static_cast<Eigen::Index>(sewn_.chart.mesh.n_vertices()), 2), {}, Eigen::VectorXd::Zero(num_rows_)};
  for (int v = 0; v < start.uv.rows(); ++v) sewn.uv.row(sewn_.vertex[v]) = start.uv.row(v);
  for (int e = 0; e < start.multipliers.size(); ++e) sewn.multipliers[row_[e]] += start.multipliers[e];
  return as_open(wirewarp::minimize(problem_, stage, sewn, control));
}

Solution SewnProblem::as_open(const Solution& sewn) const {
  std::vector<int> num_open(num_rows_, 0);
  for (const int e : row_) ++num_open[e];
  Shape open{sewn.shape.uv(sewn_.vertex, Eigen::all), {}, Eigen::VectorXd(static_cast<Eigen::Index>(row_.size()))};
  for (int e = 0; e < open.multipliers.size(); ++e) {
    open.multipliers[e] = sewn.shape.multipliers[row_[e]] / num_open[row_[e]];
  }
  Solution solution = evaluate(open_, stage_, open);
  if (solution.is_exact() || !sewn.is_exact()) solution.status = sewn.status;
  solution.iterations = sewn.iterations;
  solution.factorizations = sewn.factorizations;
  return solution;
}

std::unique_ptr<SewnProblem> sew_slits(const Problem& open, const Stage& stage, const std::vector<Slit>& slits) {
  std::optional<SewnChart> sewn = sew(open.chart(), slits);
  return sewn ? std::make_unique<SewnProblem>(open, stage, std::move(*sewn)) : nullptr;
}

}  // namespace wirewarp
