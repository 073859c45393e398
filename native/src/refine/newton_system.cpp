// SPDX-License-Identifier: GPL-3.0-or-later
#include "refine/newton_system.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <set>

#include "in_threads.h"
#include "mesh/connected_parts.h"

namespace wirewarp {
namespace {

// Holds what nothing else does. The softest mode of a square sheet has 2π² against a mass of 1: 1e-4 shortens its step
// by a few millionths.
constexpr double kMass = 1e-4;
// Far above the stiffness at a vertex, which is some units (cotangents of angles), and far below that of edges: what it
// rounds off is 1e-10.
constexpr double kPin = 1e6;
// Far above any curvature of f + λᵀc along a wire, so that a failed factorization tells of the null space of J alone.
// Each step of the method of multipliers gains as many digits as ρ has over the stiffness of the surface: seven or so.
constexpr double kSmallestStiffness = 1e8;
// Over the largest diagonal entry of the Hessian at an edge's ends: fairness makes short edges stiffer than 1e8. No
// more: what the entries of short edges round off must stay far below the stiffness of the surface.
constexpr double kStiffness = 10;
constexpr int kMultiplierSteps = 3;  // mostly one is enough, and what three do not mend rounding has spoiled
// Of changes of length, over how far the ends of edges move apart or aside: what a step is wrong by, steps back to
// exact lengths mend.
constexpr double kAccuracy = 1e-9;
constexpr double kRough = 1e-5;  // the same, for ∂λ/∂h: what one solve gives; steps are corrected after it
// Least pivot over the largest diagonal entry: ten times the error that kRough leaves.
constexpr double kWellPositive = 1e-4;
constexpr std::size_t kColumnsAtOnce = 4;  // what the Cholesky kernels take
constexpr int kManyVariations = 200;       // beyond, eigenvalues cost more than the Newton system

std::vector<VertexPair> coupled_vertices(const FairShapeError& objective, const LengthConstraints& constraints) {
  std::vector<VertexPair> pairs;
  objective.list_pairs(pairs);
  for (int e = 0; e < constraints.size(); ++e) {  // all others are edges of triangles
    if (constraints.is_linear(e)) pairs.push_back({constraints.edges()[e].a, constraints.edges()[e].b});
  }
  return pairs;
}

/// A third of the faces around each vertex, over the area of all in its connected part.
Eigen::VectorXd lumped_mass(const Chart& chart, const std::vector<ConnectedPart>& parts) {
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
  for (const ConnectedPart& part : parts) {
    const Eigen::VectorXd own = mass(part.vertices);
    mass(part.vertices) = own / own.sum();
  }
  return mass;
}

/// A vertex near the middle of each connected part, and the one farthest away from it.
std::vector<VertexPair> pinned_vertices(const Chart& chart, const std::vector<ConnectedPart>& parts) {
  const auto point = [&](int v) { return chart.mesh.point(VertexHandle(v)); };
  const auto nearer_to = [&](const OpenMesh::Vec3d& place) {
    return [&point, place](int a, int b) { return (point(a) - place).sqrnorm() < (point(b) - place).sqrnorm(); };
  };
  std::vector<VertexPair> pinned;
  for (const ConnectedPart& part : parts) {
    OpenMesh::Vec3d center(0, 0, 0);
    for (const int v : part.vertices) center += point(v);
    center /= static_cast<double>(part.vertices.size());
    const int middle = *std::min_element(part.vertices.begin(), part.vertices.end(), nearer_to(center));
    const int farthest = *std::max_element(part.vertices.begin(), part.vertices.end(), nearer_to(point(middle)));
    pinned.push_back({middle, farthest});
  }
  return pinned;
}

/// With so much more on the diagonal that it is positive, from 1e-5 of the largest entry on: ten times as much each
/// time.
Eigen::MatrixXd shifted(Eigen::MatrixXd symmetric) {
  constexpr double kMost = 1e6;  // of a matrix without any positive entry on its diagonal nothing can be made
  const double largest = symmetric.diagonal().cwiseAbs().maxCoeff();
  double shift = 0;
  for (double next = 1e-5; next < kMost; next *= 10) {
    symmetric.diagonal().array() += (next - shift) * largest;
    shift = next;
    if (Eigen::LLT<Eigen::MatrixXd>(symmetric).info() == Eigen::Success) break;
  }
  return symmetric;
}

}  // namespace

Eigen::MatrixXd make_positive(const Eigen::MatrixXd& symmetric) {
  const Eigen::LLT<Eigen::MatrixXd> factor(symmetric);  // a small part of the cost of the eigenvalues
  if (factor.info() == Eigen::Success) {
    const Eigen::ArrayXd pivots = factor.matrixLLT().diagonal().array().square();
    if (pivots.minCoeff() > kWellPositive * symmetric.diagonal().maxCoeff()) return symmetric;
  }
  if (symmetric.rows() > kManyVariations) return shifted(symmetric);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(symmetric);
  const Eigen::ArrayXd magnitudes = eigen.eigenvalues().cwiseAbs();
  const Eigen::VectorXd positive = magnitudes.max(1e-6 * magnitudes.maxCoeff()).matrix();
  return eigen.eigenvectors() * positive.asDiagonal() * eigen.eigenvectors().transpose();
}

Eigen::MatrixXd hessian_h(const Eigen::SparseMatrix<double>& lengths, const Eigen::MatrixXd& multipliers) {
  const Eigen::MatrixXd s = -(lengths.transpose() * multipliers);
  return (s + s.transpose()) / 2;
}

NewtonSystem::NewtonSystem(const Chart& chart, FairShapeError& objective, const LengthConstraints& constraints,
                           const Positions2& positions, const StopToken& stop)
    : objective_(objective),
      constraints_(constraints),
      matrix_(static_cast<int>(chart.mesh.n_vertices()), coupled_vertices(objective, constraints)) {
  const std::vector<ConnectedPart> parts = find_connected_parts(chart.mesh);
  pinned_ = pinned_vertices(chart, parts);
  std::vector<int> part_of_vertex(chart.mesh.n_vertices());
  for (std::size_t p = 0; p < parts.size(); ++p) {
    for (const int v : parts[p].vertices) part_of_vertex[v] = static_cast<int>(p);
  }
  for (const LengthConstraints::Edge& edge : constraints.edges()) part_of_edge_.push_back(part_of_vertex[edge.a]);
  objective_.attach_to(matrix_);
  objective_.add_constant_hessian(matrix_);
  stiffness_.resize(constraints.size());
  for (int e = 0; e < constraints.size(); ++e) {
    const LengthConstraints::Edge& edge = constraints.edges()[e];
    edge_blocks_.push_back(matrix_.block(std::max(edge.a, edge.b), std::min(edge.a, edge.b)));
    const double largest = std::max(matrix_.largest_diagonal(edge.a), matrix_.largest_diagonal(edge.b));
    stiffness_[e] = std::max(kSmallestStiffness, kStiffness * largest);
  }
  const Eigen::VectorXd mass = kMass * lumped_mass(chart, parts);
  for (int v = 0; v < mass.size(); ++v) matrix_.add_diagonal(v, mass[v] * Eigen::Matrix2d::Identity());
  for (const VertexPair& pin : pinned_) matrix_.add_diagonal(pin[0], kPin * Eigen::Matrix2d::Identity());
  constant_ = matrix_.values();
  stop.check();
  const DissectionTree tree = nested_dissection(matrix_.graph(), positions);
  stop.check();
  cholesky_.emplace(matrix_.lower(), tree, 2, has_second_core());
  std::vector<int> wire_vertices;
  for (const LengthConstraints::Edge& edge : constraints.edges()) {
    wire_vertices.push_back(edge.a);
    wire_vertices.push_back(edge.b);
  }
  on_wires_ = cholesky_->fronts_reaching(wire_vertices);
  off_wires_ = cholesky_->others(on_wires_);
}

void NewtonSystem::assemble(const Positions2& uv, const Eigen::VectorXd& multipliers, const Convexity& convexity,
                            double stiffness_share) {
  matrix_.set_values(constant_);
  objective_.add_curvature(uv, convexity.curvature, matrix_);
  directions_ = constraints_.directions(uv);
  for (int e = 0; e < constraints_.size(); ++e) {
    const LengthConstraints::Edge& edge = constraints_.edges()[e];
    const bool counts = convexity.keep_compression || multipliers[e] > 0;
    const Eigen::Vector2d d = directions_.row(e).transpose();
    Eigen::Matrix2d block = stiffness_share * stiffness_[e] * d * d.transpose();
    if (counts) block += constraints_.curvature(e, uv, multipliers[e]);
    matrix_.add_diagonal(edge.a, block);
    matrix_.add_diagonal(edge.b, block);
    matrix_.add(edge_blocks_[e], -block);
  }
  if (convexity.curvature == Curvature::none) return;  // the Laplacian resists turns: a pin would press a dent
  if (!objective_.is_free_to_turn()) return;
  for (const VertexPair& pin : pinned_) {
    const Eigen::Vector2d arm = (uv.row(pin[1]) - uv.row(pin[0])).transpose().normalized();
    const Eigen::Vector2d turn(-arm.y(), arm.x());
    matrix_.add_diagonal(pin[1], kPin * turn * turn.transpose());
  }
}

bool NewtonSystem::factorize(const Positions2& uv, const Eigen::VectorXd& multipliers, const Convexity& convexity,
                             const StopToken& stop) {
  assemble(uv, multipliers, convexity, 1);
  ++num_factorizations_;
  return cholesky_->factorize(matrix_.lower(), stop);
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

/// A⁻¹ Jᵀ τ on the wires, one a column.
Eigen::MatrixXd NewtonSystem::response(const Eigen::MatrixXd& tensions) const {
  const Eigen::Index num_vertices = matrix_.lower().rows() / 2;
  Eigen::MatrixXd x = Eigen::MatrixXd::Zero(2 * num_vertices, tensions.cols());
  for (Eigen::Index c = 0; c < x.cols(); ++c) {
    constraints_.add_transposed(directions_, tensions.col(c), Eigen::Map<Positions2>(x.col(c).data(), num_vertices, 2));
  }
  cholesky_->substitute_forward(x, on_wires_);
  cholesky_->substitute_back(x, on_wires_);
  return x;
}

/// J d, one a column.
Eigen::MatrixXd NewtonSystem::changes_of_length(const Eigen::MatrixXd& d) const {
  Eigen::MatrixXd changes(constraints_.size(), d.cols());
  for (Eigen::Index c = 0; c < d.cols(); ++c) {
    changes.col(c) = constraints_.apply(directions_, Eigen::Map<const Positions2>(d.col(c).data(), d.rows() / 2, 2));
  }
  return changes;
}

/// Of the ends of edges, in all columns.
double NewtonSystem::relative_motion(const Eigen::MatrixXd& d) const {
  double sum = 0;
  for (const LengthConstraints::Edge& edge : constraints_.edges()) {
    sum += (d.middleRows<2>(2 * edge.b) - d.middleRows<2>(2 * edge.a)).squaredNorm();
  }
  return std::sqrt(sum);
}

/// (H + Jᵀ ρ J) d = r₁ + Jᵀ (ρ r₂ − λ), then λ += ρ (J d − r₂): the first row holds after every step, the second is
/// better by a factor of about ρ over the stiffness of the surface.
void NewtonSystem::improve(const Eigen::MatrixXd& r2, double accuracy, Solution& solution) const {
  for (int i = 0; i < kMultiplierSteps; ++i) {
    Eigen::MatrixXd tensions = stiffness_.asDiagonal() * r2 - solution.multipliers;
    solution.d += response(tensions - solution.tensions);
    solution.tensions = std::move(tensions);
    const Eigen::MatrixXd missing = changes_of_length(solution.d) - r2;
    solution.multipliers += stiffness_.asDiagonal() * missing;
    if (missing.norm() <= accuracy * relative_motion(solution.d)) return;
  }
}

NewtonSystem::Solution NewtonSystem::solve_roughly(const Positions2& r1, const Eigen::VectorXd& r2) const {
  Solution solution;
  solution.tensions = stiffness_.cwiseProduct(r2);
  Positions2 b = r1;
  constraints_.add_transposed(directions_, solution.tensions.col(0), b);
  solution.d = Eigen::Map<const Eigen::VectorXd>(b.data(), b.size());
  cholesky_->substitute_forward(solution.d, cholesky_->all());
  cholesky_->substitute_back(solution.d, on_wires_);
  solution.multipliers = stiffness_.asDiagonal() * (changes_of_length(solution.d) - r2);
  return solution;
}

void NewtonSystem::improve(const Eigen::MatrixXd& r2, Solution& solution) const { improve(r2, kAccuracy, solution); }

NewtonSystem::Solution NewtonSystem::solve_on_wires(const Positions2& r1, const Eigen::VectorXd& r2) const {
  Solution solution = solve_roughly(r1, r2);
  improve(r2, solution);
  return solution;
}

/// The connected parts that a column of T has edges in.
std::set<int> NewtonSystem::parts_of_column(int w) const {
  std::set<int> parts;
  for (Eigen::SparseMatrix<double>::InnerIterator entry(constraints_.elastic_lengths(), w); entry; ++entry) {
    parts.insert(part_of_edge_[entry.row()]);
  }
  return parts;
}

/// The columns of T in groups of such as have no connected part in common: those of one group are solved for as one.
std::vector<std::vector<int>> NewtonSystem::columns_apart() const {
  const Eigen::SparseMatrix<double>& lengths = constraints_.elastic_lengths();
  std::vector<std::vector<int>> groups;
  std::vector<std::set<int>> parts_of_group;
  for (int w = 0; w < lengths.cols(); ++w) {
    const std::set<int> parts = parts_of_column(w);
    const auto is_apart = [&](const std::set<int>& others) {
      return std::none_of(parts.begin(), parts.end(), [&](int part) { return others.count(part) > 0; });
    };
    const auto g = std::find_if(parts_of_group.begin(), parts_of_group.end(), is_apart) - parts_of_group.begin();
    groups.resize(std::max(groups.size(), static_cast<std::size_t>(g) + 1));
    parts_of_group.resize(groups.size());
    groups[g].push_back(w);
    parts_of_group[g].insert(parts.begin(), parts.end());
  }
  return groups;
}

Eigen::MatrixXd NewtonSystem::dlambda_dh(const StopToken& stop) const {
  const Eigen::SparseMatrix<double>& lengths = constraints_.elastic_lengths();
  Eigen::MatrixXd multipliers = Eigen::MatrixXd::Zero(lengths.rows(), lengths.cols());
  const std::vector<std::vector<int>> groups = columns_apart();
  for (std::size_t first = 0; first < groups.size() && stop.may_go_on(); first += kColumnsAtOnce) {
    const auto columns = static_cast<Eigen::Index>(std::min(kColumnsAtOnce, groups.size() - first));
    const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(lengths.rows(), columns);
    Solution solution{Eigen::MatrixXd::Zero(matrix_.lower().rows(), columns), none, none};
    Eigen::MatrixXd changes = none;
    for (Eigen::Index c = 0; c < columns; ++c) {
      for (const int w : groups[first + c]) changes.col(c) += lengths.col(w);
    }
    improve(changes, kRough, solution);
    for (Eigen::Index c = 0; c < columns; ++c) {
      for (const int w : groups[first + c]) {
        const std::set<int> parts = parts_of_column(w);
        for (int e = 0; e < constraints_.size(); ++e) {
          if (parts.count(part_of_edge_[e]) > 0) multipliers(e, w) = solution.multipliers(e, c);
        }
      }
    }
  }
  return multipliers;
}

Eigen::MatrixXd NewtonSystem::stiffness_by_variation() const {
  const Eigen::SparseMatrix<double>& lengths = constraints_.elastic_lengths();
  const Eigen::SparseMatrix<double> stretched = stiffness_.asDiagonal() * lengths;
  Eigen::MatrixXd result = Eigen::SparseMatrix<double>(lengths.transpose() * stretched).toDense();
  constexpr Eigen::Index kColumns = kColumnsAtOnce;
  for (Eigen::Index first = 0; first < lengths.cols(); first += kColumns) {
    const Eigen::Index columns = std::min(kColumns, lengths.cols() - first);
    const Eigen::MatrixXd tensions = stretched.middleCols(first, columns).toDense();
    result.middleCols(first, columns) -= stretched.transpose() * changes_of_length(response(tensions));
  }
  return result;
}

Eigen::VectorXd NewtonSystem::least_change(const Eigen::VectorXd& r2) const {
  return response(stiffness_.cwiseProduct(r2));
}

Positions2 NewtonSystem::finish(const Eigen::VectorXd& d_on_wires) const {
  Positions2 d = Eigen::Map<const Positions2>(d_on_wires.data(), d_on_wires.size() / 2, 2);
  cholesky_->substitute_back(Eigen::Map<Eigen::VectorXd>(d.data(), d.size()), off_wires_);
  return d;
}

}  // namespace wirewarp
