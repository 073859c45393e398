// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/sewn_problem.h"

#include <stdexcept>
#include <utility>

namespace wirewarp {

SewnProblem::SewnProblem(const RefineTask& open, SewnChart sewn)
    : sewn_(std::move(sewn)),
      network_(build_held_network(sewn_.chart)),
      fairness_(open.fairness),
      target_(open.target) {
  for (const WireEdge& edge : open.network.edges) {
    const HalfedgeHandle h = open.chart.mesh.halfedge_handle(edge.edge, 0);
    const auto sewn_end = [&](VertexHandle v) { return VertexHandle(sewn_.vertex[v.idx()]); };
    const HalfedgeHandle there = sewn_.chart.mesh.find_halfedge(sewn_end(open.chart.mesh.from_vertex_handle(h)),
                                                                sewn_end(open.chart.mesh.to_vertex_handle(h)));
    const int sewn_edge = there.is_valid() ? network_.wire_edge_of_edge[sewn_.chart.mesh.edge_handle(there).idx()] : -1;
    if (sewn_edge < 0) throw std::logic_error("an edge of a wire is none any more once slits are sewn");
    row_.push_back(sewn_edge);
  }
  num_rows_ = static_cast<int>(network_.edges.size());
  if (!open.cloth) return;
  cloth_ = *open.cloth;
  if (!cloth_->flat_ratio.empty()) {
    cloth_->flat_ratio.assign(sewn_.chart.mesh.n_edges(), 1);
    for (std::size_t e = 0; e < open.network.edges.size(); ++e) {
      cloth_->flat_ratio[network_.edges[row_[e]].edge.idx()] = open.cloth->flat_ratio[open.network.edges[e].edge.idx()];
    }
  }
  for (GrainRow& grain : cloth_->grains) {
    grain.a = sewn_.vertex[grain.a];
    grain.b = sewn_.vertex[grain.b];
    row_.push_back(num_rows_++);
  }
}

RefinementStart SewnProblem::to_sewn(const RefinementStart& open) const {
  RefinementStart start{Positions2(static_cast<Eigen::Index>(sewn_.chart.mesh.n_vertices()), 2),
                        Eigen::VectorXd::Zero(num_rows_)};
  for (int v = 0; v < open.uv.rows(); ++v) start.uv.row(sewn_.vertex[v]) = open.uv.row(v);
  for (int e = 0; e < open.multipliers.size(); ++e) start.multipliers[row_[e]] += open.multipliers[e];
  return start;
}

RefinementStart SewnProblem::to_open(const RefinedShape& sewn) const {
  std::vector<int> num_open(num_rows_, 0);
  for (const int e : row_) ++num_open[e];
  RefinementStart start{sewn.uv(sewn_.vertex, Eigen::all), Eigen::VectorXd(static_cast<Eigen::Index>(row_.size()))};
  for (int e = 0; e < start.multipliers.size(); ++e)
    start.multipliers[e] = sewn.multipliers[row_[e]] / num_open[row_[e]];
  return start;
}

RefinedShape SewnProblem::as_open(const RefineTask& open, const RefinedShape& sewn) const {
  RefinedShape shape = evaluate_shape(open, to_open(sewn));
  if (shape.is_exact() || !sewn.is_exact()) shape.status = sewn.status;
  shape.iterations = sewn.iterations;
  return shape;
}

}  // namespace wirewarp
