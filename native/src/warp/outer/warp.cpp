// SPDX-License-Identifier: GPL-3.0-or-later
#include "warp/outer/warp.h"

#include <utility>

#include "surface/mesh/geometry.h"

namespace wirewarp {
namespace {

/// This share of the mean curvature is added to all curvatures, so that a length without effect on E gets a finite
/// step. Half or twice this share changes no test of elastic wires.
constexpr double kFloor = 1e-4;

Eigen::VectorXd edge_lengths(const WireNetwork& network) {
  Eigen::VectorXd lengths(static_cast<Eigen::Index>(network.edges.size()));
  for (int e = 0; e < lengths.size(); ++e) lengths[e] = network.edges[e].length;
  return lengths;
}

}  // namespace

Warp::Warp(const Chart& chart, const WireNetwork& network, NodeWeight node_weight, Inner inner, const StopToken& stop)
    : network_(network),
      num_vertices_(static_cast<int>(chart.mesh.n_vertices())),
      num_parts_(static_cast<int>(chart.wire_parts.size())),
      inner_(inner),
      inner_problem_(network, node_weight, stop),
      layout_(chart, network),
      placement_(chart, network, stop),
      shape_error_(chart),
      rest_lengths_(edge_lengths(network)),
      area_(surface_area(chart.mesh)) {}

WarpedShape Warp::operator()(const Eigen::VectorXd& variation) {
  Eigen::VectorXd lengths = lengths_of(variation);
  InnerSolution inner = inner_problem_.solve(lengths, inner_);
  return lay_out(std::move(inner), std::move(lengths));
}

WarpedShape Warp::follow(const WarpedShape& from, const Eigen::VectorXd& variation) {
  Eigen::VectorXd lengths = lengths_of(variation);
  InnerSolution inner = inner_problem_.follow(from.inner, lengths);
  return lay_out(std::move(inner), std::move(lengths));
}

Eigen::VectorXd Warp::lengths_of(const Eigen::VectorXd& variation) const {
  Eigen::VectorXd lengths = rest_lengths_;
  for (int e = 0; e < lengths.size(); ++e) {
    const int part = network_.edges[e].part;
    if (part >= 0) lengths[e] *= 1 + variation[part];
  }
  return lengths;
}

WarpedShape Warp::lay_out(InnerSolution inner, Eigen::VectorXd lengths) const {
  WarpedShape shape;
  shape.inner = std::move(inner);
  shape.lengths = std::move(lengths);
  if (!shape.inner.is_feasible) return shape;
  shape.uv.resize(num_vertices_, 2);
  layout_.place(shape.inner.headings, shape.lengths, shape.uv);
  placement_.place(shape.uv);
  return shape;
}

double Warp::shape_error(const WarpedShape& shape) const { return shape_error_.energy(shape.uv) / area_; }

/// Turns ∂E/∂uv into the derivative with respect to h, divided by the area. Needs the linearized inner problem.
Eigen::VectorXd Warp::by_variation(const WarpedShape& shape, Positions2 by_uv) const {
  placement_.pull_back(by_uv);
  Eigen::VectorXd by_headings;
  Eigen::VectorXd by_lengths;
  layout_.pull_back(shape.inner.headings, shape.lengths, by_uv, by_headings, by_lengths);
  by_lengths = inner_problem_.total_derivative(shape.inner, by_headings, by_lengths);

  Eigen::VectorXd result = Eigen::VectorXd::Zero(num_parts_);
  for (int e = 0; e < by_lengths.size(); ++e) {
    const int part = network_.edges[e].part;
    if (part >= 0) result[part] += rest_lengths_[e] * by_lengths[e];
  }
  return result / area_;
}

Eigen::VectorXd Warp::gradient(const WarpedShape& shape) {
  inner_problem_.linearize(shape.inner, shape.lengths);
  Positions2 by_uv;
  shape_error_.energy_and_gradient(shape.uv, by_uv);
  return by_variation(shape, std::move(by_uv));
}

Eigen::MatrixXd Warp::gauss_newton_hessian(const WarpedShape& shape, const std::vector<int>& parts) {
  inner_problem_.linearize(shape.inner, shape.lengths);
  const auto size = static_cast<Eigen::Index>(parts.size());
  Eigen::MatrixXd hessian(size, size);
  for (Eigen::Index column = 0; column < size; ++column) {
    stop().check();
    const Eigen::VectorXd d_lengths =
        lengths_of(Eigen::VectorXd::Unit(num_parts_, parts[static_cast<std::size_t>(column)])) - rest_lengths_;
    Positions2 d_uv = Positions2::Zero(num_vertices_, 2);
    layout_.push_forward(shape.inner.headings, shape.lengths, inner_problem_.change_of_headings(shape.inner, d_lengths),
                         d_lengths, d_uv);
    placement_.place(d_uv);
    hessian.col(column) = by_variation(shape, shape_error_.times_gauss_newton(shape.uv, d_uv))(parts);
  }
  hessian = (hessian + hessian.transpose()).eval() / 2;
  hessian.diagonal().array() += kFloor * hessian.diagonal().mean();
  return hessian;
}

}  // namespace wirewarp
