// SPDX-License-Identifier: GPL-3.0-or-later
#include "refine/refine_chart.h"

#include <algorithm>
#include <exception>
#include <optional>
#include <stdexcept>
#include <utility>

#include "arap/free_boundary_arap.h"
#include "outer/choose_variation.h"
#include "refine/coarse_start.h"
#include "refine/injective_shape.h"
#include "refine/open_slits.h"
#include "refine/project_to_lengths.h"
#include "refine/refine_budget.h"
#include "refine/unfold.h"
#include "topology/process_topology.h"

namespace wirewarp {
namespace {

bool is_elastic(const WirePart& part) { return part.kind == WireKind::elastic; }

RefineResult finish(RefineResult result, const RefineBudget& attempts) {
  result.shape.factorizations = attempts.factorizations();
  result.was_stopped = attempts.was_stopped();
  return result;
}

/// The least distorted shape with all elastic wires free, from a start.
RefinedShape free_elastic_wires(Chart chart, const Positions2& start, RefineBudget& attempts) {
  for (WirePart& part : chart.wire_parts) {
    if (is_elastic(part)) part.kind = WireKind::super_elastic;
  }
  return attempts.refine(chart, build_held_network(chart), start, kStartFactorizations);
}

class Stopped : public std::exception {};

/// ψ(h⁰): the paper's flat shape, before any h is chosen. None where no topology serves the wires, Eq. (1) breaks down
/// or go_on stops it.
std::optional<WarpedShape> warp_wires(const Chart& chart, const std::function<bool()>& go_on) {
  const Options plain;  // those of Eq. (1) are not the refined method's
  const auto ask = [&] {
    if (!go_on()) throw Stopped();
  };
  try {
    ask();
    const std::optional<Chart> refined = process_topology(chart);
    const Chart& prepared = refined ? *refined : chart;
    const WireNetwork network = build_wire_network(prepared);
    ask();
    Warp warp(prepared, network, plain.node_weight, plain.inner, ask);
    WarpedShape shape = start_variation(prepared, warp, variation_bounds(prepared, plain)).shape;
    if (shape.inner.is_feasible) shape.uv.conservativeResize(static_cast<Eigen::Index>(chart.mesh.n_vertices()), 2);
    return shape;
  } catch (const std::domain_error&) {
    return std::nullopt;
  } catch (const Stopped&) {
    return std::nullopt;
  }
}

enum class Goal { least_distortion, exact_lengths };

RefineResult try_all_starts(const Chart& chart, const WireNetwork& held_network, const Options& options, Goal goal,
                            RefineBudget& attempts) {
  RefineResult result;
  const auto attempt = [&](const Positions2& start) {
    result.shape = attempts.refine(chart, held_network, start, goal == Goal::exact_lengths ? 0 : kNoLimit);
    if (goal == Goal::exact_lengths && !result.shape.is_exact) {
      result.shape = attempts.refine(chart, held_network, start, 1);
    }
    return result.shape.is_exact;
  };
  const Positions2 free = free_boundary_arap(chart, kFreeSteps, {}, attempts.asking("start")).uv;
  const auto from_free_shape = [&] { return !attempts.was_stopped() && attempt(free); };
  const auto from_free_elastic_wires = [&] {
    if (attempts.was_stopped() || std::none_of(chart.wire_parts.begin(), chart.wire_parts.end(), is_elastic)) {
      return false;
    }
    const RefinedShape freed = free_elastic_wires(chart, free, attempts);
    return !attempts.was_stopped() && freed.is_exact && attempt(freed.uv);
  };
  // That with many elastic wires free takes the least time.
  const bool is_done = goal == Goal::exact_lengths ? from_free_elastic_wires() || from_free_shape()
                                                   : from_free_shape() || from_free_elastic_wires();
  if (is_done || attempts.was_stopped()) return result;

  if (std::optional<WarpedShape> warped = warp_wires(chart, attempts.asking("start"))) {
    result.inner = std::move(warped->inner);
    if (result.inner.is_feasible && attempt(warped->uv)) return result;
  }
  if (attempts.was_stopped()) return result;

  if (goal == Goal::least_distortion) {
    result.shape = refine_injectively(chart, held_network, Injectivity::local, attempts);
    if (result.shape.is_exact || attempts.was_stopped()) return result;
  }

  result.loose = relax_lengths(chart, held_network, options.fairness, free, attempts.asking("shape"));
  if (attempts.was_stopped()) return result;
  const bool is_tight =
      project_to_lengths(chart, held_network, options.fairness, result.loose.uv, attempts.asking("shape"));
  if (is_tight && !attempts.was_stopped()) attempt(result.loose.uv);
  return result;
}

/// From a start that is near the minimum, where the chart is large enough for one. Not exact where there is none.
RefinedShape refine_from_coarse(const Chart& chart, const WireNetwork& held_network, const Options& options,
                                const Tuning& tuning, RefineBudget& attempts) {
  if (chart.mesh.n_faces() < tuning.large_chart) return {};
  const auto start = start_from_coarse(chart, held_network, options, attempts.asking("start"));
  return start && !attempts.was_stopped() ? attempts.refine(chart, held_network, *start) : RefinedShape{};
}

/// As if the chart had no slits.
RefineResult refine_whole(const Chart& chart, const WireNetwork& held_network, const Options& options,
                          const Tuning& tuning, RefineBudget& attempts) {
  RefineResult result;
  if (const std::optional<Positions2> unfolded = unfold(chart)) {
    result.shape = attempts.refine(chart, held_network, *unfolded);
  }
  if (!result.shape.is_exact && !attempts.was_stopped()) {
    result.shape = refine_from_coarse(chart, held_network, options, tuning, attempts);
  }
  if (!result.shape.is_exact && !attempts.was_stopped()) {
    result = try_all_starts(chart, held_network, options, Goal::least_distortion, attempts);
  }
  return result;
}

/// Where a chart without strain lies with its slits shut, else sewn up and opened. Not exact where neither serves.
RefinedShape refine_with_slits(const Chart& chart, const WireNetwork& held_network, const std::vector<Slit>& slits,
                               const Options& options, const Tuning& tuning, RefineBudget& attempts) {
  if (const std::optional<Positions2> unfolded = unfold(chart)) {
    RefinedShape shape = attempts.refine(chart, held_network, *unfolded, 0);
    if (shape.converged) return shape;
  }
  const auto refine_sewn = [&](const Chart& sewn, const WireNetwork& sewn_network) {
    try {
      return refine_whole(sewn, sewn_network, options, tuning, attempts).shape;
    } catch (const std::domain_error&) {  // the open chart has starts of its own
      return RefinedShape{};
    }
  };
  return open_slits(chart, held_network, slits, refine_sewn, attempts);
}

}  // namespace

RefineResult refine_from_scratch(const Chart& chart, const WireNetwork& held_network, const Options& options,
                                 const GoOn& go_on) {
  RefineBudget attempts(options, go_on);
  RefineResult result = try_all_starts(chart, held_network, options, Goal::least_distortion, attempts);
  result.shape = make_injective(chart, held_network, std::move(result.shape), attempts);
  return finish(std::move(result), attempts);
}

RefineResult reach_exact_lengths(const Chart& chart, Options options, const GoOn& go_on) {
  options.max_factorizations = kExactLengthsFactorizations;
  RefineBudget attempts(options, go_on);
  return finish(try_all_starts(chart, build_held_network(chart), options, Goal::exact_lengths, attempts), attempts);
}

RefineResult refine_chart(const Chart& chart, const Options& options, const GoOn& go_on, const Tuning& tuning) {
  const WireNetwork held_network = build_held_network(chart);
  RefineBudget attempts(options, go_on);
  RefineResult result;
  if (const std::vector<Slit> slits = find_slits(chart); !slits.empty()) {
    result.shape = refine_with_slits(chart, held_network, slits, options, tuning, attempts);
  }
  if (!result.shape.is_exact && !attempts.was_stopped()) {
    result = refine_whole(chart, held_network, options, tuning, attempts);
  }
  result.shape = make_injective(chart, held_network, std::move(result.shape), attempts);
  return finish(std::move(result), attempts);
}

}  // namespace wirewarp
