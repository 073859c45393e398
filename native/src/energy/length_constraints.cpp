// SPDX-License-Identifier: GPL-3.0-or-later
#include "energy/length_constraints.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "surface/mesh/geometry.h"

namespace wirewarp {

LengthConstraints::LengthConstraints(const Chart& chart, const HeldNetwork& network, const TargetLengths* targets,
                                     const Positions2& layout)
    : rounding_length_(1e-5 * std::sqrt(surface_area(chart.mesh))) {
  std::vector<double> tolerance;
  std::map<std::pair<int, int>, int> elastic_of_run;  // index into h, by wire and part
  for (const WirePart& part : chart.wire_parts) {
    elastic_of_part_.push_back(-1);
    if (part.kind != WireKind::elastic && !is_elastic_boundary(part)) continue;
    const auto next = static_cast<int>(tolerance.size());
    elastic_of_part_.back() = part.kind == WireKind::elastic
                                  ? next
                                  : elastic_of_run.insert({{part.wire_index, part.part}, next}).first->second;
    if (elastic_of_part_.back() == next) tolerance.push_back(solver_tolerance(part));
  }
  tolerance_ = Eigen::Map<const Eigen::VectorXd>(tolerance.data(), static_cast<Eigen::Index>(tolerance.size()));
  for (const WireEdge& edge : network.edges) {
    const HalfedgeHandle h = chart.mesh.halfedge_handle(edge.edge, 0);
    const double ratio = targets && !targets->ratio.empty() ? targets->ratio[edge.edge.idx()] : 1;
    edges_.push_back({chart.mesh.from_vertex_handle(h).idx(), chart.mesh.to_vertex_handle(h).idx(), ratio * edge.length,
                      edge.part < 0 ? -1 : elastic_of_part_[edge.part]});
  }
  if (targets) {
    for (const GrainRow& grain : targets->grains) {
      edges_.push_back({grain.a, grain.b, (layout.row(grain.b) - layout.row(grain.a)).norm(), -1});
      grain_normals_.push_back(grain.normal.transpose());
    }
    flat_share_ = targets->flat_share;
  }
  std::vector<Eigen::Triplet<double>> entries;
  for (int e = 0; e < size(); ++e) {
    const Edge& edge = edges_[e];
    if (edge.elastic >= 0) entries.emplace_back(e, edge.elastic, edge.length);
  }
  elastic_lengths_.resize(size(), num_elastic());
  elastic_lengths_.setFromTriplets(entries.begin(), entries.end());
}

Eigen::VectorXd LengthConstraints::variation(const Positions2& uv) const {
  Eigen::VectorXd length = Eigen::VectorXd::Zero(num_elastic());
  for (const Edge& edge : edges_) {
    if (edge.elastic >= 0) length[edge.elastic] += flat_edge(edge, uv).norm();
  }
  const Eigen::VectorXd rest = elastic_lengths_.transpose() * Eigen::VectorXd::Ones(size());
  return length.cwiseQuotient(rest).array() - 1;
}

Eigen::VectorXd LengthConstraints::residual(const Positions2& uv, const Eigen::VectorXd& variation) const {
  Eigen::VectorXd c(size());
  for (int e = 0; e < size(); ++e) {
    const Edge& edge = edges_[e];
    if (is_linear(e)) {
      c[e] = grain_normal(e).dot(uv.row(edge.b) - uv.row(edge.a));
      continue;
    }
    const double h = edge.elastic < 0 ? 0 : variation[edge.elastic];
    const double x = flat_share_.x() * (uv(edge.b, 0) - uv(edge.a, 0));
    const double y = flat_share_.y() * (uv(edge.b, 1) - uv(edge.a, 1));
    c[e] = std::sqrt(x * x + y * y) - (1 + h) * edge.length;
  }
  return c;
}

double LengthConstraints::largest_error(const Eigen::VectorXd& residual) const {
  if (!residual.allFinite()) return std::numeric_limits<double>::infinity();
  double largest = 0;
  for (int e = 0; e < size(); ++e) {
    largest = std::max(largest, std::abs(residual[e]) / (edges_[e].length + rounding_length_));
  }
  return largest;
}

Positions2 LengthConstraints::directions(const Positions2& uv) const {
  Positions2 directions(size(), 2);
  for (int e = 0; e < size(); ++e) {
    if (is_linear(e)) {
      directions.row(e) = grain_normal(e);
      continue;
    }
    const Eigen::RowVector2d flat = flat_edge(edges_[e], uv);
    const double length = flat.norm();
    directions.row(e) = length > 0 ? (flat.cwiseProduct(flat_share_) / length).eval() : flat;
  }
  return directions;
}

Eigen::Matrix2d LengthConstraints::curvature(int e, const Positions2& uv, double multiplier) const {
  const double length = is_linear(e) ? 0 : flat_edge(edges_[e], uv).norm();
  if (!(length > 0)) return Eigen::Matrix2d::Zero();
  const Eigen::RowVector2d d = (uv.row(edges_[e].b) - uv.row(edges_[e].a)) / length;
  const Eigen::Vector2d m = flat_share_.prod() * Eigen::Vector2d(-d.y(), d.x());
  return multiplier / length * m * m.transpose();
}

Eigen::VectorXd LengthConstraints::apply(const Positions2& directions, const Eigen::Ref<const Positions2>& d) const {
  Eigen::VectorXd result(size());
  for (int e = 0; e < size(); ++e) {
    result[e] = directions.row(e).dot(d.row(edges_[e].b) - d.row(edges_[e].a));
  }
  return result;
}

void LengthConstraints::add_transposed(const Positions2& directions, const Eigen::VectorXd& multipliers,
                                       Eigen::Ref<Positions2> result) const {
  for (int e = 0; e < size(); ++e) {
    const Eigen::RowVector2d force = multipliers[e] * directions.row(e);
    result.row(edges_[e].b) += force;
    result.row(edges_[e].a) -= force;
  }
}

}  // namespace wirewarp
