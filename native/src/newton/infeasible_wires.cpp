// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/infeasible_wires.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "newton/project_to_lengths.h"
#include "newton/refine_chart.h"
#include "newton/relax_lengths.h"

namespace wirewarp {
namespace {

// Wires with larger strains are freed: first with kKept and, if that does not help, with kPerhapsKept. kKept is larger
// than the strains of 1e-4 that smoothing alone leaves.
constexpr double kKept = 5e-4, kPerhapsKept = 3e-5;
// A wire is freed if its strain_rms is larger. A smaller value may vanish if other wires change more. Half or twice
// this value changes no test of proposed tolerances.
constexpr double kUneven = 5e-3;
// Proposed tolerances are rounded up, because people type them: to multiples of 0.1%, above 0.5% to multiples of 0.5%.
constexpr double kFineStep = 1e-3, kStep = 5e-3;
constexpr double kLargest = 0.5;  // a wire that needs a larger tolerance measures nothing, so it is freed
constexpr double kFreeTolerance = std::numeric_limits<double>::infinity();
constexpr int kMaxFreeFactorizations = 40;  // as in lies_flat(); factorizations of coarse and sewn charts count, too
// Largest cost (cost_of()) of dropping wires, and again of lowering tolerances. A trial on 200 wires took half a
// second, so each search ends within about 15 s.
constexpr double kMostTrials = 30;
// Up to 8 wires get individual tolerances. More wires share a tolerance, which is faster to find and to type.
constexpr std::size_t kFewWires = 8;
/// Tolerances are not tried on more wires than this. A trial on 569 wires costs as much as 23 trials on 200 wires,
/// because n wires take n³ operations. Nets of 168 wires still get a common tolerance of 5%.
constexpr std::size_t kMostElasticWires = 200;

/// Tolerances to try, 0.1% to 50%: each is 1.3 to 2 times the tolerance before.
constexpr double kLadder[] = {0.001, 0.002, 0.003, 0.005, 0.01, 0.015, 0.02, 0.03,
                              0.05,  0.075, 0.1,   0.15,  0.2,  0.3,   0.5};

using Tolerances = std::map<int, double>;  // by wire index; infinite: the wire is free

/// Returns free tolerances for the held wires that have a chosen part. chooses(i) returns whether part i is chosen.
template <typename Chooses>
Tolerances free_wires(const Chart& chart, const Chooses& chooses) {
  Tolerances wires;
  for (std::size_t i = 0; i < chart.wire_parts.size(); ++i) {
    const WirePart& part = chart.wire_parts[i];
    if (is_held(part) && chooses(static_cast<Eigen::Index>(i))) wires[part.wire_index] = kFreeTolerance;
  }
  return wires;
}

/// Returns free tolerances for the wires whose lengths the relaxed shape changes. kept: largest violation of a
/// tolerance that does not count as a change.
Tolerances wires_to_free(const Chart& chart, const RelaxedShape& relaxed, double kept) {
  return free_wires(
      chart, [&](Eigen::Index i) { return relaxed.strain_rms[i] > kUneven || relaxed.tolerance_violation[i] > kept; });
}

double rounded_up(double tolerance) {
  const double step = tolerance > kStep ? kStep : kFineStep;
  return tolerance > kLargest ? kFreeTolerance : std::ceil(tolerance / step - 1e-9) * step;
}

Tolerances doubled(Tolerances tolerances) {
  for (auto& [wire, tolerance] : tolerances) tolerance = rounded_up(2 * tolerance);
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

/// Returns free tolerances for the wires that exceed their tolerances by more than kLadder[0]. free: a solution in
/// which all wires are free.
Tolerances free_wires_that_change(const Chart& chart, const Solution& free) {
  return free_wires(chart, [&](Eigen::Index i) {
    const WirePart& part = chart.wire_parts[static_cast<std::size_t>(i)];
    return std::abs(free.shape.variation[i]) > solver_tolerance(part) + kLadder[0];
  });
}

/// Finds tolerances with which a chart has a flat shape, possibly flipped, that keeps the lengths of outline and wires.
class ToleranceSearch {
 public:
  /// starts: layouts near exact lengths.
  ToleranceSearch(const Chart& chart, const InternalOptions& options, std::vector<Positions2> starts, StopToken stop)
      : chart_(chart), options_(options), starts_(std::move(starts)), stop_(std::move(stop)) {}

  bool work(const Tolerances& tolerances) const {
    const Chart looser = with_tolerances(chart_, tolerances);
    const Problem problem(looser, options_.fairness);
    return std::any_of(starts_.begin(), starts_.end(), [&](Positions2 uv) {
      Budget budget(kMaxProjectFactorizations);
      return project_to_lengths(problem, uv, {budget, stop_});
    });
  }

  /// Returns tolerances that work, on as few wires as possible and as small as possible. If more than kFewWires wires
  /// remain, they stay free. tolerances: free wires that work.
  Tolerances on_few_wires(Tolerances tolerances) {
    trials_ = 0;
    drop_wires(tolerances);
    if (tolerances.size() > kFewWires) return tolerances;
    trials_ = 0;
    lower(tolerances, wires_of(tolerances));
    for (const int wire : wires_of(tolerances)) lower(tolerances, {wire});
    return tolerances;
  }

  /// Returns the first tolerances with which the chart lies flat, or no wires.
  Tolerances first_flat(const std::vector<Tolerances>& choices) {
    const auto found = std::find_if(choices.begin(), choices.end(), [&](const auto& each) { return are_flat(each); });
    return found == choices.end() ? Tolerances() : *found;
  }

  /// Returns the wires with the lowest common tolerance with which the chart lies flat, among the values of kLadder
  /// below `below`. Returns no wires if there are too many, or if the highest tolerance does not work.
  Tolerances lowest_shared(const Tolerances& wires, double below) {
    Tolerances lowest;
    const auto all_have = [&](double tolerance) {
      Tolerances shared = wires;
      for (auto& [wire, own] : shared) own = tolerance;
      return shared;
    };
    const double* const low = std::begin(kLadder);
    const double* const high = std::lower_bound(low, std::end(kLadder), below);
    if (wires.empty() || wires.size() > kMostElasticWires || low == high || !work(all_have(*(high - 1)))) return lowest;
    std::partition_point(low, high, [&](double rung) {
      Tolerances shared = all_have(rung);
      if (!is_looser(shared) || !are_flat(shared)) return true;
      lowest = std::move(shared);
      return false;
    });
    return lowest;
  }

 private:
  bool are_flat(const Tolerances& tolerances) {
    stop_.check();
    if (tolerances.empty()) return false;
    const auto [answer, is_new] = known_.try_emplace(tolerances, false);
    if (is_new) answer->second = lies_flat(with_tolerances(chart_, tolerances), options_, stop_);
    return answer->second;
  }

  static std::vector<int> wires_of(const Tolerances& tolerances) {
    std::vector<int> wires;
    for (const auto& [wire, tolerance] : tolerances) wires.push_back(wire);
    return wires;
  }

  bool try_instead(Tolerances& tolerances, Tolerances others) {
    if (trials_ >= kMostTrials) return false;
    stop_.check();
    trials_ += cost_of(others);
    if (!work(others)) return false;
    tolerances = std::move(others);
    return true;
  }

  /// Returns the cost of a trial, in units of a trial with kMostElasticWires elastic wires. All elastic wires count,
  /// not only the proposed wires.
  double cost_of(const Tolerances& tolerances) const {
    const Chart looser = with_tolerances(chart_, tolerances);
    const auto num_elastic = std::count_if(looser.wire_parts.begin(), looser.wire_parts.end(),
                                           [](const WirePart& part) { return part.kind == WireKind::elastic; });
    return std::max(1.0, std::pow(static_cast<double>(num_elastic) / kMostElasticWires, 3));
  }

  void drop_wires(Tolerances& tolerances) {
    std::vector<int> wires = wires_of(tolerances);
    for (std::size_t size = wires.size() / 2; size > 0; size /= 2) {
      for (std::size_t begin = 0; begin + size <= wires.size() && wires.size() > 1;) {
        Tolerances fewer = tolerances;
        for (std::size_t i = begin; i < begin + size; ++i) fewer.erase(wires[i]);
        if (!fewer.empty() && try_instead(tolerances, std::move(fewer))) {
          wires.erase(wires.begin() + static_cast<std::ptrdiff_t>(begin),
                      wires.begin() + static_cast<std::ptrdiff_t>(begin + size));
        } else {
          begin += size;
        }
      }
    }
  }

  /// Lowers the tolerances of these wires to the smallest value of kLadder that works, by bisection.
  void lower(Tolerances& tolerances, const std::vector<int>& wires) {
    std::partition_point(std::begin(kLadder), std::end(kLadder), [&](double rung) {
      Tolerances lower = tolerances;
      for (const int wire : wires) lower[wire] = std::min(lower[wire], rung);
      return lower != tolerances && !(is_looser(lower) && try_instead(tolerances, std::move(lower)));
    });
  }

  /// Returns whether all of these tolerances are larger than the present tolerances of their wires.
  bool is_looser(const Tolerances& tolerances) const {
    return std::all_of(chart_.wire_parts.begin(), chart_.wire_parts.end(), [&](const WirePart& part) {
      const auto tolerance = tolerances.find(part.wire_index);
      return tolerance == tolerances.end() || !is_held(part) || tolerance->second > part.tolerance;
    });
  }

  const Chart& chart_;
  const InternalOptions& options_;
  const std::vector<Positions2> starts_;
  const StopToken stop_;
  std::map<Tolerances, bool> known_;  // answers of are_flat(); choices repeat if doubled() changes nothing
  double trials_ = 0;
};

/// Returns whether the relaxed shape changes lengths. A longer search would then hardly find a shape with all lengths.
bool shows_conflict(const RelaxedShape& relaxed) {
  const bool are_wires_violated =
      (relaxed.strain_rms.array() > kKept || relaxed.tolerance_violation.array() > kKept).any();
  return are_wires_violated || relaxed.outline_strain > kKept;
}

/// Returns the best tolerances with which the chart lies flat, or no wires. All parameters are free wires:
/// - freed: wires that the relaxed shape changes
/// - changing: wires that change if all wires are free
/// - all: all held wires
Tolerances best_tolerances(ToleranceSearch& search, const Tolerances& freed, const Tolerances& changing,
                           const Tolerances& all) {
  const Tolerances few = search.on_few_wires(freed);
  const auto is_free = [](const auto& wire) { return std::isinf(wire.second); };
  const bool are_few_elastic = few.size() <= kFewWires && std::none_of(few.begin(), few.end(), is_free);
  Tolerances best;
  if (are_few_elastic) best = search.first_flat({few, doubled(few)});
  if (best.empty()) {
    best = search.lowest_shared(freed, kFreeTolerance);
    // A proposal with more wires is worthwhile if it more than halves the tolerance.
    const double below = best.empty() ? kFreeTolerance : best.begin()->second / 2;
    if (Tolerances of_many = search.lowest_shared(changing, below); !of_many.empty()) best = std::move(of_many);
  }
  return best.empty() ? search.first_flat({few, doubled(few), freed, all}) : best;
}

std::vector<ProposedTolerance> propose_tolerances(Problem& problem, const InternalOptions& options,
                                                  const RelaxedShape& relaxed, const StopToken& stop) {
  const Tolerances all = free_wires(problem.chart(), [](Eigen::Index) { return true; });
  if (all.empty()) return {};
  Chart chart = problem.chart();
  chart.free_map = problem.free_map(stop);  // runs with other tolerances share it
  InternalOptions brief = options;
  brief.max_factorizations = kMaxFreeFactorizations;
  brief.cloth.reset();  // this shape is only a start, so it need not suit the fabric
  const Solution free = refine_chart(with_tolerances(chart, all), brief, stop);
  stop.check();
  if (!free.is_exact()) return {};
  ToleranceSearch search(chart, options, {relaxed.uv, free.shape.uv}, stop);
  Tolerances freed = wires_to_free(chart, relaxed, kKept);
  if (!search.work(freed)) {
    freed = wires_to_free(chart, relaxed, kPerhapsKept);
    if (!search.work(freed)) freed.clear();
  }
  std::vector<ProposedTolerance> listed;
  for (const auto& [wire, tolerance] : best_tolerances(search, freed, free_wires_that_change(chart, free), all))
    listed.push_back({wire, tolerance});
  return listed;
}

}  // namespace

LengthDiagnosis diagnose_lengths(Problem& problem, const InternalOptions& options, const StopToken& stop) {
  Budget budget(kMaxRelaxFactorizations);
  const RelaxedShape relaxed = relax_lengths(problem, problem.free_map(stop), {budget, stop});
  stop.check();
  return {propose_tolerances(problem, options, relaxed, stop), shows_conflict(relaxed)};
}

}  // namespace wirewarp
