// SPDX-License-Identifier: GPL-3.0-or-later
#include "refine/refine_chart.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include "outer/choose_variation.h"
#include "outer/free_arap.h"
#include "refine/coarse_start.h"
#include "refine/tighten_lengths.h"
#include "refine/unfold.h"
#include "topology/process_topology.h"

namespace wirewarp {
namespace {

constexpr std::size_t kLargeChart = 20'000;  // faces: from here on a coarse start saves more than it costs

bool is_elastic(const WirePart& part) { return part.kind == WireKind::elastic; }

/// The starts of one chart: they share the limits, and are counted together.
class Attempts {
 public:
  Attempts(const Options& options, const GoOn& go_on)
      : fairness_(options.fairness), max_factorizations_(options.max_factorizations), go_on_(go_on) {}

  bool was_stopped() const { return was_stopped_; }

  /// Asks in a stage, and not again after a no.
  std::function<bool()> asking(const char* stage) {
    return [this, stage] {
      was_stopped_ = was_stopped_ || !go_on_(stage);
      return !was_stopped_;
    };
  }

  RefinedShape refine(const Chart& chart, const WireNetwork& network, const RefinementStart& start,
                      int max_factorizations = std::numeric_limits<int>::max()) {
    const int most = std::min(max_factorizations, max_factorizations_ - factorizations_);
    RefinedShape shape = refine_shape(chart, network, fairness_, start, {most, asking("shape")});
    factorizations_ += shape.factorizations;
    return shape;
  }

  ChartRefinement finish(ChartRefinement result) const {
    result.shape.factorizations = factorizations_;
    result.was_stopped = was_stopped_;
    return result;
  }

 private:
  double fairness_;
  int max_factorizations_;
  const GoOn& go_on_;
  int factorizations_ = 0;
  bool was_stopped_ = false;
};

/// The least distorted shape with all elastic wires free, from a start.
RefinedShape free_elastic_wires(Chart chart, const Positions2& start, Attempts& attempts) {
  for (WirePart& part : chart.wire_parts) {
    if (is_elastic(part)) part.kind = WireKind::super_elastic;
  }
  return attempts.refine(chart, build_held_network(chart), start, kStartFactorizations);
}

/// ψ(h⁰): the paper's flat shape, before any h is chosen. None where no topology serves the wires or Eq. (1) breaks
/// down.
std::optional<WarpedShape> warp_wires(const Chart& chart) {
  const Options plain;  // those of Eq. (1) are not the refined method's
  try {
    const std::optional<Chart> refined = process_topology(chart);
    const Chart& prepared = refined ? *refined : chart;
    const WireNetwork network = build_wire_network(prepared);
    Warp warp(prepared, network, plain.node_weight, plain.inner);
    WarpedShape shape = start_variation(prepared, warp, variation_bounds(prepared, plain), [] {}).shape;
    if (shape.inner.is_feasible) shape.uv.conservativeResize(static_cast<Eigen::Index>(chart.mesh.n_vertices()), 2);
    return shape;
  } catch (const std::domain_error&) {
    return std::nullopt;
  }
}

ChartRefinement try_all_starts(const Chart& chart, const WireNetwork& held_network, const Options& options,
                               Attempts& attempts) {
  ChartRefinement result;
  const auto attempt = [&](const Positions2& start) {
    result.shape = attempts.refine(chart, held_network, start);
    return result.shape.is_exact;
  };
  const Positions2 free = flatten_freely(chart, kFreeSteps, {}, attempts.asking("start")).uv;
  if (attempts.was_stopped() || attempt(free) || attempts.was_stopped()) return result;

  if (std::any_of(chart.wire_parts.begin(), chart.wire_parts.end(), is_elastic)) {
    const RefinedShape freed = free_elastic_wires(chart, free, attempts);
    if (attempts.was_stopped() || (freed.is_exact && attempt(freed.uv)) || attempts.was_stopped()) return result;
  }

  if (std::optional<WarpedShape> warped = warp_wires(chart)) {
    result.inner = std::move(warped->inner);
    if (result.inner.is_feasible && attempt(warped->uv)) return result;
  }
  if (attempts.was_stopped()) return result;

  result.loose = loosen_lengths(chart, held_network, options.fairness, free, attempts.asking("shape"));
  if (attempts.was_stopped()) return result;
  if (tighten_lengths(chart, held_network, options.fairness, result.loose.uv)) attempt(result.loose.uv);
  return result;
}

}  // namespace

ChartRefinement refine_from_scratch(const Chart& chart, const WireNetwork& held_network, const Options& options,
                                    const GoOn& go_on) {
  Attempts attempts(options, go_on);
  return attempts.finish(try_all_starts(chart, held_network, options, attempts));
}

ChartRefinement refine_chart(const Chart& chart, const Options& options, const GoOn& go_on) {
  const WireNetwork held_network = build_held_network(chart);
  Attempts attempts(options, go_on);
  ChartRefinement result;
  if (const std::optional<Positions2> unfolded = unfold(chart)) {
    result.shape = attempts.refine(chart, held_network, *unfolded);
  } else if (chart.mesh.n_faces() >= kLargeChart) {
    const auto start = start_from_coarse(chart, held_network, options, attempts.asking("start"));
    if (start && !attempts.was_stopped()) result.shape = attempts.refine(chart, held_network, *start);
  }
  if (!result.shape.is_exact && !attempts.was_stopped()) {
    result = try_all_starts(chart, held_network, options, attempts);
  }
  return attempts.finish(std::move(result));
}

}  // namespace wirewarp
