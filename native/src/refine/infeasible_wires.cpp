// SPDX-License-Identifier: GPL-3.0-or-later
#include "refine/infeasible_wires.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>

namespace wirewarp {
namespace {

// Strains that pass for the rounding of the smoothing, 1e-4: first those that are plainly none, then those that may be.
constexpr double kKept = 5e-4, kPerhapsKept = 3e-5;
constexpr double kUneven = 5e-3;                  // strain_rms that a larger variation of other wires may take away
constexpr double kFineStep = 1e-3, kStep = 5e-3;  // of what is proposed: 0.1 %, from 0.5 % on 0.5 %
constexpr double kLargest = 0.5;
constexpr double kFree = std::numeric_limits<double>::infinity();
constexpr double kSpare = 1.1;  // of tolerances that a free shape needs

using Tolerances = std::map<int, double>;  // by wire

bool is_held(const WirePart& part) { return part.kind == WireKind::rigid || part.kind == WireKind::elastic; }

/// Wires that give way in the loose shape, with what they need beyond their tolerance.
Tolerances find_needs(const Chart& chart, const RelaxedShape& loose, double kept) {
  Tolerances needs;
  for (std::size_t i = 0; i < chart.wire_parts.size(); ++i) {
    const WirePart& part = chart.wire_parts[i];
    const auto p = static_cast<Eigen::Index>(i);
    const double need = loose.strain_rms[p] > kUneven ? kFree : loose.tolerance_violation[p];
    if (is_held(part) && need > kept) needs[part.wire_index] = std::max(needs[part.wire_index], need);
  }
  return needs;
}

double rounded_up(double tolerance) {
  const double step = tolerance > kStep ? kStep : kFineStep;
  return tolerance > kLargest ? kFree : std::ceil(tolerance / step - 1e-9) * step;
}

/// The wires' own tolerances and so many times their needs.
Tolerances widened(const Chart& chart, const Tolerances& needs, double times) {
  Tolerances tolerances;
  for (const WirePart& part : chart.wire_parts) {
    const auto need = needs.find(part.wire_index);
    if (need == needs.end() || !is_held(part)) continue;
    tolerances[part.wire_index] = rounded_up(part.tolerance + times * need->second);
  }
  return tolerances;
}

Chart with_tolerances(Chart chart, const Tolerances& tolerances) {
  for (WirePart& part : chart.wire_parts) {
    const auto tolerance = tolerances.find(part.wire_index);
    if (tolerance == tolerances.end() || !is_held(part)) continue;
    part.tolerance = tolerance->second;
    part.kind = std::isinf(part.tolerance) ? WireKind::super_elastic : WireKind::elastic;
  }
  return chart;
}

Tolerances all_free(Tolerances tolerances) {
  for (auto& [wire, tolerance] : tolerances) tolerance = kFree;
  return tolerances;
}

/// One tolerance for all wires that leave their own when they are free, as far as they do.
Tolerances shared(const Chart& chart, const RefinedShape& free) {
  std::set<int> wires;
  double most = 0;
  for (std::size_t i = 0; i < chart.wire_parts.size(); ++i) {
    const WirePart& part = chart.wire_parts[i];
    const double needed = std::abs(free.variation[static_cast<Eigen::Index>(i)]);
    if (!is_held(part) || needed <= part.tolerance) continue;
    wires.insert(part.wire_index);
    most = std::max(most, needed);
  }
  Tolerances tolerances;
  for (const int wire : wires) tolerances[wire] = rounded_up(kSpare * most);
  return tolerances;
}

Tolerances free_wires(const Chart& chart) {
  Tolerances tolerances;
  for (const WirePart& part : chart.wire_parts) {
    if (is_held(part)) tolerances[part.wire_index] = kFree;
  }
  return tolerances;
}

std::vector<ProposedTolerance> listed(const Tolerances& tolerances) {
  std::vector<ProposedTolerance> proposed;
  for (const auto& [wire, tolerance] : tolerances) proposed.push_back({wire, tolerance});
  return proposed;
}

}  // namespace

std::vector<ProposedTolerance> propose_tolerances(const Chart& chart, const Options& options,
                                                  const RefineResult& refined, const std::function<bool()>& go_on,
                                                  const Tuning& tuning) {
  const Tolerances all = free_wires(chart);
  if (all.empty()) return {};
  const GoOn may_go_on = [&](const char*) { return go_on(); };
  const auto with = [&](const Tolerances& tolerances, const auto& refine) -> RefineResult {
    try {
      return refine(with_tolerances(chart, tolerances));
    } catch (const std::domain_error&) {  // these do not serve; others may
      return {};
    }
  };
  const RefineResult free = with(all, [&](const Chart& freed) {
    Options brief = options;
    brief.max_factorizations = kStartFactorizations;
    return refine_chart(freed, brief, may_go_on, tuning);
  });
  if (free.was_stopped || !free.shape.is_exact) return {};
  const Tolerances plain = find_needs(chart, refined.loose, kKept);
  const Tolerances possible = find_needs(chart, refined.loose, kPerhapsKept);
  const Tolerances candidates[] = {widened(chart, plain, 1),    widened(chart, plain, 2),  widened(chart, possible, 1),
                                   widened(chart, possible, 2), shared(chart, free.shape), all_free(plain),
                                   all_free(possible)};
  std::set<Tolerances> tried{{}, all};
  for (const Tolerances& tolerances : candidates) {
    if (!tried.insert(tolerances).second) continue;
    const RefineResult trial =
        with(tolerances, [&](const Chart& looser) { return reach_exact_lengths(looser, options, may_go_on); });
    if (trial.was_stopped) return {};
    if (trial.shape.is_exact) return listed(tolerances);
  }
  return listed(all);
}

}  // namespace wirewarp
