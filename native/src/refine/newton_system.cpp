// SPDX-License-Identifier: GPL-3.0-or-later
#include "refine/newton_system.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "index.h"
#include "mesh/geometry.h"

namespace wirewarp {
namespace {

constexpr double kMass = 1e-4;
constexpr double kPin = 1e6;
constexpr double kSmallestStiffness = 1e8;
constexpr double kStiffness = 1e4;  // over the largest diagonal entry of the Hessian at an edge's ends
constexpr int kMultiplierSteps = 3;
constexpr int kColumnsAtOnce = 4;  // what the Cholesky kernels take

std::vector<VertexPair> coupled_vertices(const FairShapeError& objective) {
  std::vector<VertexPair> pairs;
  objective.list_pairs(pairs);
  return pairs;
}

/// A third of the faces around each vertex, over the area of all.
Eigen::VectorXd lumped_mass(const Chart& chart) {
  Eigen::VectorXd mass = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(chart.mesh.n_vertices()));
  for (const FaceHandle f : chart.mesh.faces()) {
    const HalfedgeHandle h = chart.mesh.halfedge_handle(f), next = chart.mesh.next_halfedge_handle(h);
    const auto origin = chart.mesh.point(chart.mesh.from_vertex_handle(h));
    const auto along = chart.mesh.point(chart.mesh.to_vertex_handle(h)) - origin;
    const auto back = chart.mesh.point(chart.mesh.to_vertex_handle(next)) - origin;
    for (const VertexHandle v :
         {chart.mesh.from_vertex_handle(h), chart.mesh.to_vertex_handle(h), chart.mesh.to_vertex_handle(next)}) {
      mass[v.idx()] += (along % back).norm();
    }
  }
  return mass / mass.sum();
}

/// A vertex near the middle of the surface, and the one farthest away from it.
VertexPair pinned_vertices(const Chart& chart) {
  OpenMesh::Vec3d center(0, 0, 0);
  for (const VertexHandle v : chart.mesh.vertices()) center += chart.mesh.point(v);
  center /= static_cast<double>(chart.mesh.n_vertices());
  const auto nearer_to = [&](const OpenMesh::Vec3d& point) {
    return [&chart, point](VertexHandle a, VertexHandle b) {
      return (chart.mesh.point(a) - point).sqrnorm() < (chart.mesh.point(b) - point).sqrnorm();
    };
  };
  const VertexHandle middle =
      *std::min_element(chart.mesh.vertices_begin(), chart.mesh.vertices_end(), nearer_to(center));
  const VertexHandle farthest =
      *std::max_element(chart.mesh.vertices_begin(), chart.mesh.vertices_end(), nearer_to(chart.mesh.point(middle)));
  return {middle.idx(), farthest.idx()};
}

}  // namespace

Eigen::MatrixXd make_positive(const Eigen::MatrixXd& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(symmetric);
  const Eigen::ArrayXd magnitudes = eigen.eigenvalues().cwiseAbs();
  const Eigen::VectorXd positive = magnitudes.max(1e-6 * magnitudes.maxCoeff()).matrix();
  return eigen.eigenvectors() * positive.asDiagonal() * eigen.eigenvectors().transpose();
}

NewtonSystem::NewtonSystem(const Chart& chart, FairShapeError& objective, const LengthConstraints& constraints,
                           const Positions2& positions)
    : objective_(objective),
      constraints_(constraints),
      matrix_(static_cast<int>(chart.mesh.n_vertices()), coupled_vertices(objective)),
      pinned_(pinned_vertices(chart)) {
  objective_.attach_to(matrix_);
  objective_.add_constant_hessian(matrix_);
  stiffness_.resize(constraints.size());
  for (int e = 0; e < constraints.size(); ++e) {
    const LengthConstraints::Edge& edge = constraints.edges()[at(e)];
    edge_blocks_.push_back(matrix_.block(std::max(edge.a, edge.b), std::min(edge.a, edge.b)));
    const double largest = std::max(matrix_.largest_diagonal(edge.a), matrix_.largest_diagonal(edge.b));
    stiffness_[e] = std::max(kSmallestStiffness, kStiffness * largest);
  }
  const Eigen::VectorXd mass = kMass * lumped_mass(chart);
  for (int v = 0; v < mass.size(); ++v) matrix_.add_diagonal(v, mass[v] * Eigen::Matrix2d::Identity());
  matrix_.add_diagonal(pinned_[0], kPin * Eigen::Matrix2d::Identity());
  constant_ = matrix_.values();
  cholesky_.emplace(matrix_.lower(), nested_dissection(matrix_.graph(), positions), 2, num_factor_threads());
  std::vector<int> wire_vertices, vertices(at(static_cast<int>(chart.mesh.n_vertices())));
  for (const LengthConstraints::Edge& edge : constraints.edges()) {
    wire_vertices.push_back(edge.a);
    wire_vertices.push_back(edge.b);
  }
  std::iota(vertices.begin(), vertices.end(), 0);
  on_wires_ = cholesky_->branches_to(wire_vertices);
  everywhere_ = cholesky_->branches_to(vertices);
}

void NewtonSystem::assemble(const Positions2& uv, const Eigen::VectorXd& multipliers, const Convexity& convexity,
                            double stiffness_share) {
  matrix_.set_values(constant_);
  objective_.add_curvature(uv, convexity.curvature, matrix_);
  directions_ = constraints_.directions(uv);
  for (int e = 0; e < constraints_.size(); ++e) {
    const LengthConstraints::Edge& edge = constraints_.edges()[at(e)];
    const double length = (uv.row(edge.b) - uv.row(edge.a)).norm();
    const bool counts = length > 0 && (convexity.keeps_pressure || multipliers[e] > 0);
    const double across = counts ? multipliers[e] / length : 0;
    const Eigen::Vector2d d = directions_.row(e).transpose(), n(-d.y(), d.x());
    const Eigen::Matrix2d block = stiffness_share * stiffness_[e] * d * d.transpose() + across * n * n.transpose();
    matrix_.add_diagonal(edge.a, block);
    matrix_.add_diagonal(edge.b, block);
    matrix_.add(edge_blocks_[at(e)], -block);
  }
  const Eigen::Vector2d arm = (uv.row(pinned_[1]) - uv.row(pinned_[0])).transpose().normalized();
  const Eigen::Vector2d turn(-arm.y(), arm.x());
  matrix_.add_diagonal(pinned_[1], kPin * turn * turn.transpose());
}

bool NewtonSystem::factorize(const Positions2& uv, const Eigen::VectorXd& multipliers, const Convexity& convexity) {
  assemble(uv, multipliers, convexity, 1);
  ++num_factorizations_;
  return cholesky_->factorize(matrix_.lower());
}

Eigen::SparseMatrix<double> NewtonSystem::hessian(const Positions2& uv, const Eigen::VectorXd& multipliers,
                                                  const Convexity& convexity) {
  assemble(uv, multipliers, convexity, 0);
  return matrix_.lower();
}

Positions2 NewtonSystem::apply_inverse(const Positions2& b) const {
  Positions2 x = b;
  cholesky_->solve_in_place(Eigen::Map<Eigen::VectorXd>(x.data(), x.size()));
  return x;
}

/// A⁻¹ Jᵀ of tensions in the wires.
Positions2 NewtonSystem::response(const Eigen::VectorXd& tensions, Where wanted) const {
  Positions2 x = Positions2::Zero(matrix_.lower().rows() / 2, 2);
  constraints_.add_transposed(directions_, tensions, x);
  cholesky_->solve_in_place(Eigen::Map<Eigen::VectorXd>(x.data(), x.size()), on_wires_,
                            wanted == Where::on_wires ? on_wires_ : everywhere_);
  return x;
}

/// ρ (J d − r₂)
Eigen::VectorXd NewtonSystem::excess_tensions(const Positions2& d, const Eigen::VectorXd& r2) const {
  return stiffness_.cwiseProduct(constraints_.apply(directions_, d) - r2);
}

/// (H + Jᵀ ρ J) d = r₁ + Jᵀ (ρ r₂ − λ), then λ += ρ (J d − r₂): the first row holds after every step, the second is
/// better by a factor of about ρ over the stiffness of the surface. After the first step d changes by −A⁻¹ Jᵀ λ.
void NewtonSystem::solve(const Positions2& r1, const Eigen::VectorXd& r2, Positions2& d,
                         Eigen::VectorXd& multipliers) const {
  Positions2 b = r1;
  constraints_.add_transposed(directions_, stiffness_.cwiseProduct(r2), b);
  const Positions2 first = apply_inverse(b);
  multipliers = excess_tensions(first, r2);
  for (int i = 1; i < kMultiplierSteps; ++i) {
    d = first + response(-multipliers, i + 1 < kMultiplierSteps ? Where::on_wires : Where::everywhere);
    multipliers += excess_tensions(d, r2);
  }
}

void NewtonSystem::solve(const Eigen::VectorXd& r2, Positions2& d, Eigen::VectorXd& multipliers) const {
  multipliers = Eigen::VectorXd::Zero(constraints_.size());
  for (int i = 0; i < kMultiplierSteps; ++i) {
    d = response(stiffness_.cwiseProduct(r2) - multipliers,
                 i + 1 < kMultiplierSteps ? Where::on_wires : Where::everywhere);
    multipliers += excess_tensions(d, r2);
  }
}

/// The same steps for several elastic parts at once, on wires alone.
Eigen::MatrixXd NewtonSystem::hessian_by_variation() const {
  const Eigen::MatrixXd lengths = constraints_.elastic_lengths();
  Eigen::MatrixXd multipliers = Eigen::MatrixXd::Zero(lengths.rows(), lengths.cols());
  for (Eigen::Index first = 0; first < lengths.cols(); first += kColumnsAtOnce) {
    const Eigen::Index columns = std::min<Eigen::Index>(kColumnsAtOnce, lengths.cols() - first);
    for (int i = 0; i < kMultiplierSteps; ++i) {
      Eigen::MatrixXd x(matrix_.lower().rows(), columns);
      Positions2 one;
      for (Eigen::Index c = 0; c < columns; ++c) {
        one = Positions2::Zero(x.rows() / 2, 2);
        constraints_.add_transposed(directions_,
                                    stiffness_.cwiseProduct(lengths.col(first + c)) - multipliers.col(first + c), one);
        x.col(c) = Eigen::Map<const Eigen::VectorXd>(one.data(), one.size());
      }
      cholesky_->solve_in_place(x, on_wires_, on_wires_);
      for (Eigen::Index c = 0; c < columns; ++c) {
        one = Eigen::Map<const Positions2>(x.col(c).data(), x.rows() / 2, 2);
        multipliers.col(first + c) += excess_tensions(one, lengths.col(first + c));
      }
    }
  }
  const Eigen::MatrixXd s = -lengths.transpose() * multipliers;
  return (s + s.transpose()) / 2;
}

Positions2 NewtonSystem::least_change(const Eigen::VectorXd& r2, Where wanted) const {
  return response(stiffness_.cwiseProduct(r2), wanted);
}

}  // namespace wirewarp
