// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/refine_chart.h"

#include <memory>

#include "base/attempt.h"
#include "newton/injective_shape.h"
#include "newton/minimize.h"
#include "newton/open_slits.h"
#include "newton/refine_cloth.h"
#include "newton/sewn_problem.h"
#include "newton/starts.h"
#include "newton/unfold.h"
#include "surface/charts/folded_faces.h"
#include "surface/charts/isoperimetric.h"

namespace wirewarp {
namespace {

/// Largest number of factorizations that lies_flat() spends, because pieces that need more are better cut. With limits
/// from 20 to 100, proposed seams fix all 43 test models. They make 94 pieces with 20, and 92 with 100.
constexpr int kMostToLieFlat = 40;

/// Returns the first exact shape to which a start leads. large_chart: least number of faces for which the starts for
/// large charts are tried.
Solution try_starts(Problem& problem, Stage stage, std::size_t large_chart, const Control& control) {
  Solution found;
  bool is_any_infeasible = false;
  for (const Start& start : kStarts) {
    if (start.is_for_large_charts && problem.chart().mesh.n_faces() < large_chart) continue;
    const std::optional<Shape> made = attempt([&] { return start.make(problem, control); });
    if (control.stop.is_stopped()) break;
    if (!made) continue;
    stage.injectivity = start.injectivity;
    found = minimize(problem, stage, *made, control.in("shape"));
    if (found.is_exact()) {
      found.start = start.name;
      return found;
    }
    is_any_infeasible = is_any_infeasible || found.status == SolutionStatus::infeasible;
  }
  found.status = control.stop.is_stopped() ? SolutionStatus::cancelled
                 : is_any_infeasible       ? SolutionStatus::infeasible
                                           : SolutionStatus::singular;
  return found;
}

/// Returns the unfolded chart, with shut slits, if unfolding causes no strain. Otherwise sews the slits, minimizes, and
/// opens the slits. If this fails, too, the solution is not exact.
Solution refine_with_slits(Problem& problem, const Stage& stage, std::size_t large_chart, const Control& control) {
  if (const std::optional<Shape> flat = unfold(problem.chart())) {
    Solution unfolded = evaluate(problem, stage, *flat);
    unfolded.start = kStarts.front().name;
    if (unfolded.is_converged()) return unfolded;
  }
  const std::unique_ptr<SewnProblem> sewn = sew_slits(problem, stage, problem.slits());
  if (!sewn || is_outline_too_short(sewn->problem().chart())) return {};
  const Solution whole = try_starts(sewn->problem(), stage, large_chart, control);
  if (!whole.is_exact()) return {};
  Solution found = sewn->as_open(whole);
  if (!found.is_exact()) return found;
  found = open_slits(problem, stage, found, control.in("shape"));
  found.start = "sewn";
  return found;
}

}  // namespace

Solution refine_chart(Problem& problem, const InternalOptions& options, const Control& control) {
  const Stage stage{nullptr, nullptr, Injectivity::none, options.cloth ? Target::rough : options.target};
  Solution found;
  if (!problem.slits().empty()) found = refine_with_slits(problem, stage, options.large_chart, control);
  if (!found.is_exact()) found = try_starts(problem, stage, options.large_chart, control);
  if (options.makes_injective) make_injective(problem, stage, control, found);
  if (options.cloth && found.is_exact()) refine_cloth(problem, options, control.in("shape"), found);
  return found;
}

Solution refine_chart(const Chart& chart, const InternalOptions& options, const StopToken& stop) {
  Problem problem(chart, options.fairness);
  Budget budget(options.max_factorizations);
  return refine_chart(problem, options, {budget, stop});
}

bool lies_flat(const Chart& chart, const InternalOptions& options, const StopToken& stop) {
  if (chart.error || is_outline_too_short(chart)) return false;
  InternalOptions brief = options;
  brief.max_factorizations = kMostToLieFlat;  // replaces the user's limit, which is for the piece itself
  brief.cloth.reset();                        // a chart has a flat shape in every fabric or in none
  const Solution found = refine_chart(chart, brief, stop);
  return found.is_exact() && !has_folds(chart.mesh, found.shape.uv);
}

}  // namespace wirewarp
