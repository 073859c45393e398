// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/relax_lengths.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "newton/newton_state.h"
#include "numerics/optimize/line_search.h"

namespace wirewarp {
namespace {

constexpr double kWeightOfExcess = 10;       // V over the square root of the area; far larger than the forces in wires
constexpr double kWeightOfUnevenness = 100;  // W of wire parts over √area; above V, so that tolerances grow first
constexpr double kWeightOfBoundary = 1000;   // W of boundary edges; much larger, so that outlines change last
// Share of the tolerance that may be used, so that h stays within the tolerance in spite of smoothing.
constexpr double kWithinTolerance = 0.99;
constexpr double kSmoothing[] = {1e-2, 1e-3, 1e-4};  // σ; the last value does not separate strains below 1e-4 from 0
constexpr int kMaxRelaxSteps = kMaxRelaxFactorizations / 3;  // number of steps for each σ
constexpr double kWorthwhile = 1e-5;                         // least predicted decrease over Φ
constexpr double kShortestRelaxStep = 1e-3;                  // after ten halvings

/// Returns the chart with all held wire parts elastic, whatever their tolerance, so that the edges of a part share a
/// variation. Parts with one edge are rigid, because their residual r replaces the variation.
Chart with_variations(Chart chart) {
  for (WirePart& part : chart.wire_parts) {
    if (is_held(part)) part.kind = part.half_edges.size() > 1 ? WireKind::elastic : WireKind::rigid;
  }
  return chart;
}

class RelaxedLengths {
 public:
  RelaxedLengths(const Problem& problem, const Positions2& start, const StopToken& stop);

  void minimize(double smoothing, const Control& control);
  RelaxedShape shape() const;

 private:
  struct Group {
    double weight;      // W
    double length = 0;  // L
    int part;           // -1: boundary
  };

  void make_groups(const HeldNetwork& network);
  Eigen::VectorXd residual(const Iterate& iterate) const;
  Eigen::VectorXd mean_squares(const Eigen::VectorXd& residual) const;
  Eigen::VectorXd stiffness_of_edges(const Eigen::VectorXd& residual, double smoothing) const;
  Eigen::VectorXd tolerance_violation(const Eigen::VectorXd& variation) const;
  double value(const Iterate& iterate, double smoothing) const;
  Step step(double smoothing, const StopToken& stop);

  const Chart& chart_;  // with variations
  double size_;         // square root of the area
  LengthConstraints constraints_;
  FairShapeError objective_;
  NewtonSystem system_;
  const Eigen::SparseMatrix<double>& lengths_;  // T
  Eigen::VectorXd part_length_, tolerance_;     // L, ε of parts with a variation
  Eigen::VectorXd slack_;                       // ε l of wire edges without a variation; 0 for other edges
  std::vector<Group> groups_;
  std::vector<int> group_of_edge_;
  Iterate now_;
};

RelaxedLengths::RelaxedLengths(const Problem& problem, const Positions2& start, const StopToken& stop)
    : chart_(problem.chart()),
      size_(std::sqrt(problem.area())),
      constraints_(problem.constraints({})),
      objective_(problem.objective({})),
      system_(chart_, objective_, constraints_, start, stop),
      lengths_(constraints_.elastic_lengths()),
      part_length_(lengths_.transpose() * Eigen::VectorXd::Ones(constraints_.size())),
      tolerance_(kWithinTolerance * constraints_.tolerance()),
      slack_(Eigen::VectorXd::Zero(constraints_.size())),
      now_{start, constraints_.variation(start)} {
  make_groups(problem.network());
}

void RelaxedLengths::make_groups(const HeldNetwork& network) {
  std::vector<int> group_of_part(chart_.wire_parts.size(), -1);
  for (int e = 0; e < constraints_.size(); ++e) {
    const WireEdge& edge = network.edges[e];
    const bool is_shared = !edge.is_boundary && constraints_.edges()[e].elastic >= 0;
    int group = is_shared ? group_of_part[edge.part] : -1;
    if (group < 0) {
      group = static_cast<int>(groups_.size());
      const double weight = edge.is_boundary ? kWeightOfBoundary : is_shared ? kWeightOfUnevenness : kWeightOfExcess;
      groups_.push_back({weight * size_, 0, edge.is_boundary ? -1 : edge.part});
      if (is_shared) group_of_part[edge.part] = group;
    }
    if (!edge.is_boundary && !is_shared) {
      slack_[e] = kWithinTolerance * solver_tolerance(chart_.wire_parts[edge.part]) * edge.length;
    }
    groups_[group].length += edge.length;
    group_of_edge_.push_back(group);
  }
}

/// Returns length l times residual r of each edge. For parts with one edge, the residual begins beyond the tolerance.
Eigen::VectorXd RelaxedLengths::residual(const Iterate& iterate) const {
  const Eigen::VectorXd missing = constraints_.residual(iterate.uv, iterate.variation);
  return missing - missing.cwiseMax(-slack_).cwiseMin(slack_);
}

/// Returns m, one per group.
Eigen::VectorXd RelaxedLengths::mean_squares(const Eigen::VectorXd& residual) const {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(groups_.size()));
  for (int e = 0; e < constraints_.size(); ++e) {
    const int group = group_of_edge_[e];
    result[group] += residual[e] * residual[e] / constraints_.edges()[e].length / groups_[group].length;
  }
  return result;
}

/// Returns x with the sign of h.
Eigen::VectorXd RelaxedLengths::tolerance_violation(const Eigen::VectorXd& variation) const {
  return variation - variation.cwiseMax(-tolerance_).cwiseMin(tolerance_);
}

double RelaxedLengths::value(const Iterate& iterate, double smoothing) const {
  double result = objective_.value(iterate.uv);
  const auto magnitude = [&](double square) { return std::sqrt(square + smoothing * smoothing) - smoothing; };
  const Eigen::VectorXd squares = mean_squares(residual(iterate));
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    result += groups_[g].weight * groups_[g].length * magnitude(squares[static_cast<Eigen::Index>(g)]);
  }
  const Eigen::VectorXd x = tolerance_violation(iterate.variation);
  for (int w = 0; w < x.size(); ++w) {
    result += kWeightOfExcess * size_ * part_length_[w] * magnitude(x[w] * x[w]);
  }
  return result;
}

Eigen::VectorXd RelaxedLengths::stiffness_of_edges(const Eigen::VectorXd& residual, double smoothing) const {
  const Eigen::VectorXd squares = mean_squares(residual);
  Eigen::VectorXd stiffness(constraints_.size());
  for (int e = 0; e < constraints_.size(); ++e) {
    const int group = group_of_edge_[e];
    stiffness[e] =
        groups_[group].weight / constraints_.edges()[e].length / std::sqrt(squares[group] + smoothing * smoothing);
  }
  return stiffness;
}

/// Returns the step to the minimum of f plus the energy of springs. The current weights define the stiffness of the
/// springs. With d eliminated, a dense system in Δh remains.
Step RelaxedLengths::step(double smoothing, const StopToken& stop) {
  Positions2 gradient;
  objective_.value_and_gradient(now_.uv, gradient);
  const Eigen::VectorXd missing = residual(now_);
  const Eigen::VectorXd stiffness = stiffness_of_edges(missing, smoothing);
  const Eigen::VectorXd forces = stiffness.cwiseProduct(missing);
  system_.set_stiffness(stiffness);
  Step step{{}, Eigen::VectorXd::Zero(constraints_.num_elastic()), 0};
  const bool is_positive = system_.factorize(now_.uv, forces, kConvexHessian, stop);
  stop.check();
  if (!is_positive) return step;

  const Positions2& directions = system_.directions();
  Positions2 pull_on_vertices = -gradient;
  constraints_.add_transposed(directions, -forces, pull_on_vertices);
  step.d = system_.apply_inverse(pull_on_vertices);
  const Eigen::VectorXd x = tolerance_violation(now_.variation);
  const Eigen::VectorXd spring =
      (kWeightOfExcess * size_ * part_length_.array() / (x.array().square() + smoothing * smoothing).sqrt()).matrix();
  if (x.size() > 0) {
    Eigen::MatrixXd stiffness_h = system_.stiffness_by_variation();
    stiffness_h.diagonal() += spring;
    const Eigen::VectorXd pull =
        lengths_.transpose() * (forces + stiffness.cwiseProduct(constraints_.apply(directions, step.d))) -
        spring.cwiseProduct(x);
    step.variation = stiffness_h.selfadjointView<Eigen::Lower>().ldlt().solve(pull);
    step.d += system_.finish(system_.least_change(lengths_ * step.variation));
  }
  step.slope = (gradient.array() * step.d.array()).sum() +
               forces.dot(constraints_.apply(directions, step.d) - lengths_ * step.variation) +
               spring.cwiseProduct(x).dot(step.variation);
  return step;
}

void RelaxedLengths::minimize(double smoothing, const Control& control) {
  double now = value(now_, smoothing);
  for (int i = 0; i < kMaxRelaxSteps; ++i) {
    if (!control.budget.allows()) return;
    control.budget.spend(1);
    const Step full = step(smoothing, control.stop);
    if (-full.slope <= kWorthwhile * now) return;
    double t = 1;
    Iterate trial;
    double reached = 0;
    for (; t > kShortestRelaxStep; t /= 2) {
      trial = full.from(now_, t);
      reached = value(trial, smoothing);
      if (reached <= now + kSufficientDecrease * t * full.slope) break;
    }
    if (t <= kShortestRelaxStep) return;
    now_ = std::move(trial);
    now = reached;
  }
}

RelaxedShape RelaxedLengths::shape() const {
  RelaxedShape shape;
  shape.uv = now_.uv;
  const auto num_parts = static_cast<Eigen::Index>(chart_.wire_parts.size());
  shape.tolerance_violation = shape.strain_rms = Eigen::VectorXd::Zero(num_parts);
  const Eigen::VectorXd violation = tolerance_violation(now_.variation).cwiseAbs();
  for (Eigen::Index i = 0; i < num_parts; ++i) {
    const int elastic = constraints_.elastic_of_part()[i];
    if (elastic >= 0) shape.tolerance_violation[i] = violation[elastic];
  }
  const Eigen::VectorXd squares = mean_squares(residual(now_));
  for (int e = 0; e < constraints_.size(); ++e) {
    const Group& group = groups_[group_of_edge_[e]];
    if (group.part < 0) {
      shape.outline_strain = std::max(shape.outline_strain, std::sqrt(squares[group_of_edge_[e]]));
      continue;
    }
    const bool is_shared = constraints_.edges()[e].elastic >= 0;
    double& most = (is_shared ? shape.strain_rms : shape.tolerance_violation)[group.part];
    most = std::max(most, std::sqrt(squares[group_of_edge_[e]]));
  }
  return shape;
}

}  // namespace

RelaxedShape relax_lengths(const Problem& problem, const Positions2& start, const Control& control) {
  const Chart varied = with_variations(problem.chart());
  const Problem varied_problem(varied, problem.network(), problem.fairness());
  RelaxedLengths lengths(varied_problem, start, control.stop);
  for (const double smoothing : kSmoothing) lengths.minimize(smoothing, control);
  return lengths.shape();
}

}  // namespace wirewarp
