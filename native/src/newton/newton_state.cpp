// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/newton_state.h"

#include <algorithm>
#include <limits>

#include "newton/newton_constants.h"
#include "newton/retract_to_lengths.h"
#include "surface/network/length_variation.h"

namespace wirewarp {
namespace {

/// Returns the largest f of an isometric layout with rounding errors. Rounding errors matter for slivers, and for edges
/// of 1e-8 times the size of the piece.
double find_isometric_value(const Problem& problem, const FairShapeError& objective, const Positions2& layout) {
  const double extent = (layout.colwise().maxCoeff() - layout.colwise().minCoeff()).maxCoeff();
  return std::max(NewtonConstants::isometric * problem.area(),
                  objective.value_of_rounding(std::numeric_limits<double>::epsilon() * extent));
}

}  // namespace

NewtonState::NewtonState(const Problem& the_problem, const Stage& the_stage, const Shape& start,
                         const Control& the_control)
    : problem(the_problem),
      stage(the_stage),
      control(the_control),
      constraints(problem.constraints(stage, start.uv)),
      objective(problem.objective(stage, start.uv)),
      isometric_value(find_isometric_value(problem, objective, start.uv)),
      now{start.uv, constraints.within_tolerance(constraints.variation(start.uv)), objective.value(start.uv)},
      multipliers(start.multipliers) {
  if (multipliers.size() == 0) multipliers.setZero(constraints.size());
}

double NewtonState::worthwhile_decrease() const {
  const bool is_last = stage.target == Target::minimum;
  const double share = is_last ? NewtonConstants::worthwhile : NewtonConstants::worthwhile_on_the_way;
  return std::max(share * now.value, isometric_value);
}

bool NewtonState::factorize(const Convexity& convexity) {
  if (!system) system.emplace(problem.chart(), objective, constraints, now.uv, control.stop);
  control.budget.spend(1);
  return system->factorize(now.uv, multipliers, convexity, control.stop);
}

bool NewtonState::evaluate(Iterate& trial) const {
  if (control.stop.is_stopped()) return false;
  trial.variation = constraints.within_tolerance(trial.variation);
  if (!retract_to_lengths(constraints, *system, trial.variation, trial.uv, control.stop)) return false;
  if (objective.longest_step(now.uv, trial.uv - now.uv) < 1) return false;
  trial.value = objective.value(trial.uv);
  return true;
}

Solution NewtonState::solution(SolutionStatus status) const {
  const std::vector<WirePart>& parts = problem.chart().wire_parts;
  Solution solution;
  solution.shape = {now.uv, length_variation(problem.chart(), now.uv), multipliers};
  Eigen::VectorXd& variation = solution.shape.variation;
  for (int i = 0; i < variation.size(); ++i) {
    const int elastic = constraints.elastic_of_part()[i];
    if (parts[i].kind != WireKind::super_elastic) variation[i] = 0;
    if (elastic >= 0) variation[i] = now.variation[elastic];
  }
  solution.objective = now.value / problem.area();
  solution.length_error = length_error();
  solution.iterations = iterations;
  solution.factorizations = num_factorizations();
  solution.status = status;
  return solution;
}

}  // namespace wirewarp
