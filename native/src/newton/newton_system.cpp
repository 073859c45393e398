// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/newton_system.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "base/in_threads.h"
#include "numerics/optimize/box_quadratic.h"
#include "surface/mesh/connected_parts.h"
#include "surface/mesh/geometry.h"

namespace wirewarp {
namespace {

// Factor of M, which makes A definite for modes without stiffness. It shortens the step of a square sheet's softest
// mode (stiffness 2π² for mass 1) by a few millionths.
constexpr double kMass = 1e-4;
// Stiffness of the pins: far above the stiffness at a vertex, a few units (cotangents of angles), and far below the
// stiffness of edges. The pins cause rounding errors of 1e-10.
constexpr double kPin = 1e6;
// Smallest ρ of an edge, far above any curvature of f + λᵀc along a wire. So a factorization fails only for directions
// in the null space of J. Each multiplier step gains seven digits.
constexpr double kSmallestStiffness = 1e8;
// Smallest ratio of ρ to the Hessian's diagonal at an edge's ends. It matters for short edges, which fairness can make
// stiffer than 1e8. With a larger ratio, rounding errors would reach the surface's stiffness.
constexpr double kStiffness = 10;
constexpr int kMultiplierSteps = 3;  // usually one step is enough; after three, rounding errors prevent further gains
// Largest relative error of the length changes of a Newton step. The retraction to exact lengths corrects this error.
constexpr double kAccuracy = 1e-9;
// Least pivot of a clearly positive definite matrix over its largest diagonal entry. This is ten times the relative
// error of S if ρ keeps the lengths to five digits.
constexpr double kWellPositive = 1e-4;
constexpr int kManyVariations = 200;  // with more rows, eigenvalues cost more than the Newton system

constexpr int kPerVertex = 2;  // unknowns of a vertex of the matrix: two positions, or two h

/// Returns the index of the matrix vertex that stores the h of an elastic edge. The h come after the positions, and two
/// h share a vertex, as x and y do.
int vertex_of_variation(const LengthConstraints::Edge& edge, int num_vertices) {
  return num_vertices + edge.elastic / kPerVertex;
}

int num_matrix_vertices(const LengthConstraints& constraints, int num_vertices) {
  return num_vertices + (constraints.num_elastic() + kPerVertex - 1) / kPerVertex;
}

std::vector<VertexPair> coupled_vertices(const FairShapeError& objective, const LengthConstraints& constraints,
                                         int num_vertices) {
  std::vector<VertexPair> pairs;
  objective.list_pairs(pairs);
  // The other constraints couple the ends of mesh edges, which the objective has listed.
  for (int e = 0; e < constraints.size(); ++e) {
    const LengthConstraints::Edge& edge = constraints.edges()[e];
    if (constraints.is_linear(e)) pairs.push_back({edge.a, edge.b});
    if (edge.elastic < 0) continue;
    for (const int end : {edge.a, edge.b}) pairs.push_back({end, vertex_of_variation(edge, num_vertices)});
  }
  return pairs;
}

/// Returns a third of the area of the faces around each vertex, relative to the area of its connected part.
Eigen::VectorXd lumped_mass(const Chart& chart, const std::vector<ConnectedPart>& parts) {
  Eigen::VectorXd mass = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(chart.mesh.n_vertices()));
  for (const FaceHandle f : chart.mesh.faces()) {
    const double area = face_area(chart.mesh, f);
    for (const VertexHandle v : chart.mesh.fv_range(f)) mass[v.idx()] += area;
  }
  for (const ConnectedPart& part : parts) {
    const Eigen::VectorXd own = mass(part.vertices);
    mass(part.vertices) = own / own.sum();
  }
  return mass;
}

/// Returns, for each connected part, a vertex near its middle and the vertex farthest from that vertex.
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

/// Adds to the diagonal until the matrix is positive definite: first 1e-5 of the largest entry, then ten times as much
/// each time.
Eigen::MatrixXd shifted(Eigen::MatrixXd symmetric) {
  constexpr double kMost = 1e6;  // limit for a matrix that no diagonal makes positive
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
  const Eigen::LLT<Eigen::MatrixXd> factor(symmetric);  // costs far less than the eigenvalues
  if (factor.info() == Eigen::Success) {
    const Eigen::ArrayXd pivots = factor.matrixLLT().diagonal().array().square();
    if (pivots.minCoeff() > kWellPositive * symmetric.diagonal().maxCoeff()) return symmetric;
  }
  if (symmetric.rows() > kManyVariations) return shifted(symmetric);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(symmetric);
  const Eigen::ArrayXd magnitudes = eigen.eigenvalues().cwiseAbs();
  // The condition number is then at most 1e6, so that solutions keep ten digits.
  const Eigen::VectorXd positive = magnitudes.max(1e-6 * magnitudes.maxCoeff()).matrix();
  return eigen.eigenvectors() * positive.asDiagonal() * eigen.eigenvectors().transpose();
}

NewtonSystem::NewtonSystem(const Chart& chart, FairShapeError& objective, const LengthConstraints& constraints,
                           const Positions2& positions, const StopToken& stop)
    : objective_(objective),
      constraints_(constraints),
      matrix_(num_matrix_vertices(constraints, static_cast<int>(chart.mesh.n_vertices())),
              coupled_vertices(objective, constraints, static_cast<int>(chart.mesh.n_vertices()))),
      num_positions_(positions.size()) {
  const std::vector<ConnectedPart> parts = find_connected_parts(chart.mesh);
  pinned_ = pinned_vertices(chart, parts);
  objective_.attach_to(matrix_);
  objective_.add_constant_hessian(matrix_);
  stiffness_.resize(constraints.size());
  for (int e = 0; e < constraints.size(); ++e) {
    const LengthConstraints::Edge& edge = constraints.edges()[e];
    edge_blocks_.push_back(matrix_.block(std::max(edge.a, edge.b), std::min(edge.a, edge.b)));
    const double largest = std::max(matrix_.largest_diagonal(edge.a), matrix_.largest_diagonal(edge.b));
    stiffness_[e] = std::max(kSmallestStiffness, kStiffness * largest);
    if (edge.elastic < 0) continue;
    const int h = vertex_of_variation(edge, static_cast<int>(positions.rows()));
    elastic_blocks_.push_back({matrix_.block(h, edge.a), matrix_.block(h, edge.b)});
  }
  const Eigen::VectorXd mass = kMass * lumped_mass(chart, parts);
  for (int v = 0; v < mass.size(); ++v) matrix_.add_diagonal(v, mass[v] * Eigen::Matrix2d::Identity());
  for (const VertexPair& pin : pinned_) matrix_.add_diagonal(pin[0], kPin * Eigen::Matrix2d::Identity());
  constant_ = matrix_.values();
  stop.check();
  const DissectionTree tree = nested_dissection(matrix_.graph(), positions);
  stop.check();
  cholesky_.emplace(matrix_.lower(), tree, kPerVertex, has_second_core(), fastest_kernels(),
                    constraints.num_elastic() > 0);
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
  add_elastic_springs(stiffness_share);
  if (convexity.curvature == Curvature::none) return;  // the Laplacian resists rotation; a pin would distort the step
  if (!constraints_.are_free_to_turn()) return;
  for (const VertexPair& pin : pinned_) {
    const Eigen::Vector2d arm = (uv.row(pin[1]) - uv.row(pin[0])).transpose().normalized();
    const Eigen::Vector2d turn(-arm.y(), arm.x());
    matrix_.add_diagonal(pin[1], kPin * turn * turn.transpose());
  }
}

/// Adds the terms that couple h with the positions: ρ l d̂ at the end a of an edge, and −ρ l d̂ at its end b. Adds ρ l²
/// to the diagonal of h.
void NewtonSystem::add_elastic_springs(double stiffness_share) {
  auto blocks = elastic_blocks_.begin();
  for (int e = 0; e < constraints_.size(); ++e) {
    const LengthConstraints::Edge& edge = constraints_.edges()[e];
    if (edge.elastic < 0) continue;
    const int row = edge.elastic % kPerVertex;
    const double tension = stiffness_share * stiffness_[e] * edge.length;
    Eigen::Matrix2d block = Eigen::Matrix2d::Zero();
    block.row(row) = tension * directions_.row(e);
    matrix_.add((*blocks)[0], block);
    matrix_.add((*blocks)[1], -block);
    block.setZero();
    block(row, row) = tension * edge.length;
    matrix_.add_diagonal(vertex_of_variation(edge, static_cast<int>(num_positions_ / kPerVertex)), block);
    ++blocks;
  }
}

bool NewtonSystem::factorize(const Positions2& uv, const Eigen::VectorXd& multipliers, const Convexity& convexity,
                             const StopToken& stop) {
  assemble(uv, multipliers, convexity, 1);
  ++num_factorizations_;
  if (!cholesky_->factorize(matrix_.lower(), stop)) return false;
  const int num_elastic = constraints_.num_elastic();
  if (num_elastic > 0) stiffness_h_ = cholesky_->schur_complement().topLeftCorner(num_elastic, num_elastic);
  return true;
}

Eigen::SparseMatrix<double> NewtonSystem::hessian(const Positions2& uv, const Eigen::VectorXd& multipliers,
                                                  const Convexity& convexity) {
  assemble(uv, multipliers, convexity, 0);
  return matrix_.lower().topLeftCorner(num_positions_, num_positions_);
}

Positions2 NewtonSystem::apply_inverse(const Positions2& b) const {
  Eigen::VectorXd all = Eigen::VectorXd::Zero(num_unknowns());
  all.head(num_positions_) = Eigen::Map<const Eigen::VectorXd>(b.data(), b.size());
  cholesky_->substitute_forward(all, cholesky_->all());
  all.tail(num_unknowns() - num_positions_).setZero();
  cholesky_->substitute_back(all, cholesky_->all());
  return Eigen::Map<const Positions2>(all.data(), b.rows(), 2);
}

/// Returns A⁻¹ Jᵀ τ on the wires, for h = 0. tensions: τ.
Eigen::VectorXd NewtonSystem::response(const Eigen::VectorXd& tensions) const {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(num_unknowns());
  constraints_.add_transposed(directions_, tensions, Eigen::Map<Positions2>(x.data(), num_positions_ / 2, 2));
  cholesky_->substitute_forward(x, on_wires_);
  x.tail(num_unknowns() - num_positions_).setZero();
  cholesky_->substitute_back(x, on_wires_);
  return x;
}

Eigen::VectorXd NewtonSystem::changes_of_length(const Eigen::VectorXd& d) const {
  return constraints_.apply(directions_, Eigen::Map<const Positions2>(d.data(), num_positions_ / 2, 2));
}

double NewtonSystem::relative_motion(const Eigen::VectorXd& d) const {
  double sum = 0;
  for (const LengthConstraints::Edge& edge : constraints_.edges()) {
    sum += (d.segment<2>(2 * edge.b) - d.segment<2>(2 * edge.a)).squaredNorm();
  }
  return std::sqrt(sum);
}

/// Substitutes b = [r₁ + Jᵀ ρ r₂; −Tᵀ ρ r₂] forward.
NewtonSystem::Reduced NewtonSystem::reduce(const Positions2& r1, const Eigen::VectorXd& r2) const {
  Reduced reduced{Eigen::VectorXd::Zero(num_unknowns()), {}, r2};
  const Eigen::VectorXd tensions = stiffness_.cwiseProduct(r2);
  reduced.d.head(num_positions_) = Eigen::Map<const Eigen::VectorXd>(r1.data(), r1.size());
  constraints_.add_transposed(directions_, tensions, Eigen::Map<Positions2>(reduced.d.data(), r1.rows(), 2));
  cholesky_->substitute_forward(reduced.d, cholesky_->all());
  // Forward substitution leaves Tᵀ ρ J A⁻¹ b in the rows of h. Subtracting Tᵀ ρ r₂ gives Tᵀλ.
  reduced.pull = reduced.d.segment(num_positions_, constraints_.num_elastic()) -
                 constraints_.elastic_lengths().transpose() * tensions;
  return reduced;
}

NewtonSystem::Solution NewtonSystem::solve(const Reduced& reduced, const Eigen::VectorXd& variation,
                                           const FrontSet& wanted) const {
  Solution solution{reduced.d, {}, {}};
  solution.d.tail(num_unknowns() - num_positions_).setZero();
  solution.d.segment(num_positions_, variation.size()) = variation;
  cholesky_->substitute_back(solution.d, wanted);
  const Eigen::VectorXd r2 = reduced.r2 + constraints_.elastic_lengths() * variation;
  solution.tensions = stiffness_.cwiseProduct(r2);
  solution.multipliers = stiffness_.cwiseProduct(changes_of_length(solution.d) - r2);
  return solution;
}

NewtonSystem::Solution NewtonSystem::solve_roughly(const Reduced& reduced, const Eigen::VectorXd& variation) const {
  return solve(reduced, variation, cholesky_->all());
}

/// Takes steps of the method of multipliers until the second row of the system holds. The first row holds after every
/// step. Each step divides the error by about ρ over the stiffness of the surface.
void NewtonSystem::improve(const Eigen::VectorXd& r2, Solution& solution) const {
  for (int i = 0; i < kMultiplierSteps; ++i) {
    Eigen::VectorXd tensions = stiffness_.cwiseProduct(r2) - solution.multipliers;
    solution.d += response(tensions - solution.tensions);
    solution.tensions = std::move(tensions);
    const Eigen::VectorXd missing = changes_of_length(solution.d) - r2;
    solution.multipliers += stiffness_.cwiseProduct(missing);
    if (missing.norm() <= kAccuracy * relative_motion(solution.d)) return;
  }
}

NewtonSystem::Solution NewtonSystem::solve_on_wires(const Reduced& reduced, const Eigen::VectorXd& variation) const {
  Solution solution = solve(reduced, variation, on_wires_);
  improve(reduced.r2 + constraints_.elastic_lengths() * variation, solution);
  return solution;
}

NewtonSystem::Solution NewtonSystem::solve_on_wires(const Positions2& r1, const Eigen::VectorXd& r2) const {
  return solve_on_wires(reduce(r1, r2), Eigen::VectorXd::Zero(constraints_.num_elastic()));
}

Eigen::VectorXd NewtonSystem::choose_variation_change(const Eigen::VectorXd& pull,
                                                      const Eigen::VectorXd& variation) const {
  if (constraints_.num_elastic() == 0) return {};
  const Eigen::VectorXd& tolerance = constraints_.tolerance();
  return minimize_quadratic_in_box(-pull, make_positive(stiffness_h_), -tolerance - variation, tolerance - variation);
}

Eigen::VectorXd NewtonSystem::least_change(const Eigen::VectorXd& r2) const {
  return response(stiffness_.cwiseProduct(r2));
}

Positions2 NewtonSystem::finish(const Eigen::VectorXd& d_on_wires) const {
  Eigen::VectorXd d = d_on_wires;
  cholesky_->substitute_back(d, off_wires_);
  return Eigen::Map<const Positions2>(d.data(), num_positions_ / 2, 2);
}

}  // namespace wirewarp
