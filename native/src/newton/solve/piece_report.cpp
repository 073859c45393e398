// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/solve/piece_report.h"

namespace wirewarp {

void report_solution(const OuterSolution& solution, PieceReport& report) {
  report.inner_solves = solution.inner_solves;
  report.outer_iterations = solution.iterations;
  report.gradient_evaluations = solution.evaluations;
  report.factorizations += solution.free_factorizations;
  const InnerSolution& inner = solution.shape.inner;
  if (!inner.is_feasible) return;
  report.constraint_residual = inner.closure_residual;
  report.projected_gradient = inner.projected_gradient;
  if (!inner.is_minimum) report.warnings.push_back("The search for wire angles ended before it reached the minimum.");
  if (!solution.converged) {
    report.warnings.push_back("The search for wire lengths ended before it reached the least distortion.");
  }
  report.termination = report.warnings.empty() ? Termination::converged : Termination::stalled;
}

namespace {

void report_shape(const Solution& solution, bool was_stopped, PieceReport& report) {
  report.constraint_residual = solution.length_error;
  report.objective = solution.objective;
  report.projected_gradient = solution.projected_gradient;
  if (!was_stopped && !solution.is_converged()) {
    report.warnings.push_back("The search for the shape ended before it reached the least distortion.");
  }
  report.termination = report.warnings.empty() ? Termination::converged : Termination::stalled;
  if (was_stopped) report_cancelled(report);
}

}  // namespace

void report_refinement(const Solution& solution, int factorizations, bool was_stopped, PieceReport& report) {
  report.outer_iterations = solution.iterations;
  report.factorizations = factorizations;
  report.start = solution.start;
  if (solution.is_exact()) report_shape(solution, was_stopped, report);
}

void report_next_refinement(const Solution& solution, bool was_stopped, PieceReport& report) {
  report.warnings.clear();
  report.outer_iterations += solution.iterations;
  report_shape(solution, was_stopped, report);
}

void report_fixed_seams(PieceReport& report) {
  if (report.termination == Termination::cancelled) return;
  report.warnings.push_back(
      "The elastic seams keep their nominal lengths, because no good shapes were found with other lengths.");
  report.termination = Termination::stalled;
}

void report_cancelled(PieceReport& report) {
  if (report.termination == Termination::cancelled) return;
  report.warnings.push_back("Canceled: the lengths are exact, but the shape could be less distorted.");
  report.termination = Termination::cancelled;
}

}  // namespace wirewarp
