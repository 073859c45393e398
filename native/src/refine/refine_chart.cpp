// SPDX-License-Identifier: GPL-3.0-or-later
#include "refine/refine_chart.h"

#include <algorithm>
#include <optional>

#include "outer/choose_variation.h"
#include "outer/free_arap.h"
#include "refine/coarse_start.h"
#include "refine/tighten_lengths.h"
#include "topology/process_topology.h"

namespace wirewarp {
namespace {

constexpr std::size_t kLargeChart = 20'000;  // faces: from here on a coarse start saves more than it costs
constexpr int kFreedFactorizations = 10;     // for a start that need not be a minimum

bool is_elastic(const WirePart& part) { return part.kind == WireKind::elastic; }

/// The least distorted shape with all elastic wires free, from a start.
RefinedShape free_elastic_wires(Chart chart, double fairness, const Positions2& start, RefinementLimits limits) {
  limits.max_factorizations = std::min(limits.max_factorizations, kFreedFactorizations);
  for (WirePart& part : chart.wire_parts) {
    if (is_elastic(part)) part.kind = WireKind::super_elastic;
  }
  return refine_shape(chart, build_held_network(chart), fairness, start, limits);
}

/// ψ(h⁰): the paper's flat shape, before any h is chosen.
WarpedShape warp_wires(const Chart& chart, const Options& options) {
  const std::optional<Chart> refined = process_topology(chart);
  const Chart& prepared = refined ? *refined : chart;
  const WireNetwork network = build_wire_network(prepared);
  Warp warp(prepared, network, options.node_weight, Inner::minimum);
  WarpedShape shape = start_variation(prepared, warp, variation_bounds(prepared, options), [] {}).shape;
  if (shape.inner.is_feasible) shape.uv.conservativeResize(static_cast<Eigen::Index>(chart.mesh.n_vertices()), 2);
  return shape;
}

}  // namespace

ChartRefinement refine_from_scratch(const Chart& chart, const WireNetwork& held_network, const Options& options,
                                    const std::function<bool()>& go_on) {
  ChartRefinement result;
  RefinementLimits limits{options.max_factorizations, [&] {
                            result.was_stopped = result.was_stopped || !go_on();
                            return !result.was_stopped;
                          }};
  result.inner.is_feasible = true;
  const FreeFlattening free = flatten_freely(chart, kFreeSteps, {}, limits.go_on);
  if (result.was_stopped) return result;
  result.shape = refine_shape(chart, held_network, options.fairness, free.uv, limits);
  int used = result.shape.factorizations;
  limits.max_factorizations -= used;
  if (result.shape.is_exact || result.was_stopped) return result;

  if (std::any_of(chart.wire_parts.begin(), chart.wire_parts.end(), is_elastic)) {
    const RefinedShape freed = free_elastic_wires(chart, options.fairness, free.uv, limits);
    used += freed.factorizations;
    limits.max_factorizations -= freed.factorizations;
    if (freed.is_exact && !result.was_stopped) {
      result.shape = refine_shape(chart, held_network, options.fairness, freed.uv, limits);
      result.shape.factorizations += used;
    }
    if (result.shape.is_exact || result.was_stopped) return result;
  }

  WarpedShape warped = warp_wires(chart, options);
  result.inner = std::move(warped.inner);
  if (result.inner.is_feasible) {
    result.shape = refine_shape(chart, held_network, options.fairness, warped.uv, limits);
    result.shape.factorizations += used;
    if (result.shape.is_exact || result.was_stopped) return result;
  }

  result.loose = loosen_lengths(chart, held_network, options.fairness, free.uv, limits.go_on);
  if (tighten_lengths(chart, held_network, options.fairness, result.loose.uv)) {
    result.shape = refine_shape(chart, held_network, options.fairness, result.loose.uv, limits);
    result.shape.factorizations += used + result.loose.factorizations;
  }
  return result;
}

ChartRefinement refine_chart(const Chart& chart, const Options& options, const std::function<bool()>& go_on) {
  const WireNetwork held_network = build_held_network(chart);
  if (chart.mesh.n_faces() < kLargeChart) return refine_from_scratch(chart, held_network, options, go_on);

  ChartRefinement result;
  const RefinementLimits limits{options.max_factorizations, [&] {
                                  result.was_stopped = result.was_stopped || !go_on();
                                  return !result.was_stopped;
                                }};
  result.inner.is_feasible = true;
  const auto start = start_from_coarse(chart, held_network, options, limits.go_on);
  if (start && !result.was_stopped) {
    result.shape = refine_shape(chart, held_network, options.fairness, *start, limits);
  }
  if (result.shape.is_exact || result.was_stopped) return result;

  const int used = result.shape.factorizations;
  Options rest = options;
  rest.max_factorizations = std::max(1, options.max_factorizations - used);
  ChartRefinement from_scratch = refine_from_scratch(chart, held_network, rest, go_on);
  from_scratch.shape.factorizations += used;
  return from_scratch;
}

}  // namespace wirewarp
