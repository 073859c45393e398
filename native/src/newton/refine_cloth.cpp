// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/refine_cloth.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "base/planar.h"
#include "newton/injective_shape.h"
#include "newton/refine_constants.h"
#include "newton/shut_slits.h"
#include "surface/mesh/geometry.h"
#include "surface/orientation/upright_direction.h"

namespace wirewarp {
namespace {

constexpr int kDirections = 36;         // every 5° of a half turn, after which a cloth is the same again
constexpr std::size_t kBestStarts = 3;  // of mostly two valleys: weft and warp, and the same exchanged
constexpr int kMaxTurns = 15;           // samples take 3 to 6
constexpr double kShorter = 4;          // after a turn that does not go down, as in a line search

/// Turned about the origin by an angle, counter-clockwise.
Positions2 turned(const Positions2& uv, double angle) {
  return uv * Eigen::Rotation2Dd(angle).toRotationMatrix().transpose();
}

class ClothRefinement {
 public:
  ClothRefinement(const Chart& chart, const InternalOptions& options, const StopToken& stop)
      : chart_(chart), network_(build_held_network(chart)), options_(options), stop_(stop) {}

  /// None where no shape for the cloth is sound.
  std::optional<RefinedShape> refine(const RefinedShape& upright, RefineBudget& budget);

 private:
  /// A layout turned to a valley of its energy.
  struct Turn {
    Positions2 uv;
    double energy;     // f over the area
    double curvature;  // of that by the angle
  };

  std::vector<Turn> best_turns(const Positions2& uv) const;
  RefineTask task(const ClothOnChart& cloth) const {
    return {chart_, network_, options_.fairness, &cloth, options_.target};
  }
  ClothOnChart cloth_held_as(const Positions2& uv) const;
  RefinedShape refine_held(const RefinementStart& start, RefineBudget& budget) const;
  RefinedShape refine_turning(const RefinedShape& upright, RefineBudget& budget) const;
  double slope_of(const RefinedShape& shape) const;
  /// As injective as the shape without a cloth: that comes first.
  bool is_sound(const RefinedShape& shape) const { return shape.is_exact() && shape.injectivity >= injectivity_; }
  bool may_go_on(RefineBudget& budget) const { return !stop_.is_stopped() && budget.allows(); }

  const Chart& chart_;
  HeldNetwork network_;
  const InternalOptions& options_;
  StopToken stop_;
  VertexPair pair_{};                            // whose direction is held
  Injectivity injectivity_ = Injectivity::none;  // of the shape without a cloth
};

ClothOnChart ClothRefinement::cloth_held_as(const Positions2& uv) const {
  return {without_stretch(*options_.cloth), {hold_direction(pair_, uv)}, {}};
}

/// Turned as the start is. If the piece overlaps itself and did not before, it is refined once more with a
/// barrier against that.
RefinedShape ClothRefinement::refine_held(const RefinementStart& start, RefineBudget& budget) const {
  const ClothOnChart cloth = cloth_held_as(start.uv);
  RefinedShape shape = refine_with_shut_slits(task(cloth), start, {budget, stop_, Injectivity::local});
  shape.injectivity = injectivity_of(chart_, shape.uv);
  if (shape.injectivity >= injectivity_ || !may_go_on(budget)) return shape;
  shape = refine_with_shut_slits(task(cloth), start, {budget, stop_, Injectivity::global});
  shape.injectivity = injectivity_of(chart_, shape.uv);
  return shape;
}

/// Of f over the area by the angle at which the shape is held: with n turned by dθ, n·d changes by |d| dθ, at the price
/// of its multiplier.
double ClothRefinement::slope_of(const RefinedShape& shape) const {
  const double length = (shape.uv.row(pair_[1]) - shape.uv.row(pair_[0])).norm();
  return shape.multipliers[shape.multipliers.size() - 1] * length / surface_area(chart_.mesh);
}

/// The best few of many directions.
std::vector<ClothRefinement::Turn> ClothRefinement::best_turns(const Positions2& uv) const {
  const ClothOnChart cloth = cloth_held_as(uv);
  const FairShapeError objective(task(cloth));
  const double area = surface_area(chart_.mesh), spacing = kPi / kDirections;
  std::array<double, kDirections> energy;
  for (int k = 0; k < kDirections; ++k) energy[k] = objective.value(turned(uv, k * spacing)) / area;
  std::vector<Turn> turns;
  for (int k = 0; k < kDirections; ++k) {
    const double before = energy[(k + kDirections - 1) % kDirections], after = energy[(k + 1) % kDirections];
    if (energy[k] > before || energy[k] >= after) continue;
    turns.push_back({turned(uv, k * spacing), energy[k], (before - 2 * energy[k] + after) / (spacing * spacing)});
  }
  if (turns.empty()) turns.push_back({uv, energy[0], 0});  // all directions are alike
  std::stable_sort(turns.begin(), turns.end(), [](const Turn& a, const Turn& b) { return a.energy < b.energy; });
  turns.resize(std::min(turns.size(), kBestStarts));
  return turns;
}

/// Newton steps by the angle, from the best of the shapes held at a few.
RefinedShape ClothRefinement::refine_turning(const RefinedShape& upright, RefineBudget& budget) const {
  RefinedShape best;
  double curvature = 0;
  for (const Turn& turn : best_turns(upright.uv)) {
    if (!may_go_on(budget)) break;
    RefinedShape shape = refine_held({turn.uv, upright.multipliers}, budget);
    if (!is_sound(shape) || (is_sound(best) && shape.objective >= best.objective)) continue;
    best = std::move(shape);
    curvature = turn.curvature;
  }
  if (!is_sound(best)) return best;
  const double longest = kPi / kDirections;
  for (int i = 0; i < kMaxTurns; ++i) {
    const double slope = slope_of(best);
    double angle = curvature > 0 ? -slope / curvature : -std::copysign(longest, slope);
    angle = std::clamp(angle, -longest, longest);
    if (std::abs(slope * angle) < RefineConstants::worthwhile * best.objective || !best.is_converged()) return best;
    if (!may_go_on(budget)) break;
    RefinedShape trial = refine_held({turned(best.uv, angle), best.multipliers}, budget);
    if (trial.is_converged() && is_sound(trial) && trial.objective < best.objective) {
      const double change = (slope_of(trial) - slope) / angle;
      curvature = change > 0 ? change : 0;
      best = std::move(trial);
    } else {
      curvature = kShorter * std::abs(slope / angle);
    }
  }
  best.status = ShapeStatus::stalled;
  return best;
}

std::optional<RefinedShape> ClothRefinement::refine(const RefinedShape& upright, RefineBudget& budget) {
  pair_ = upright_pair(chart_, upright.uv, options_);
  injectivity_ = *upright.injectivity;
  RefinementStart start{upright.uv, Eigen::VectorXd(upright.multipliers.size() + 1)};
  start.multipliers << upright.multipliers, 0;
  const bool is_turned = options_.orientation == Orientation::best;
  RefinedShape with_row = upright;
  with_row.multipliers = start.multipliers;
  RefinedShape shape = is_turned ? refine_turning(with_row, budget) : refine_held(start, budget);
  if (!is_sound(shape)) return std::nullopt;
  if (!is_turned) return shape;
  // Weft and warp are the same after a half turn: what leads up is up.
  if (upright_direction(chart_, shape.uv, options_).y() < 0) shape.uv *= -1;
  return shape;
}

}  // namespace

GrainRow hold_upright(const Chart& chart, const Positions2& uv, const Options& options) {
  return hold_direction(upright_pair(chart, uv, options), uv);
}

void refine_cloth(const Chart& chart, const InternalOptions& options, RefineBudget& budget, const StopToken& stop,
                  RefineResult& result) {
  stand_upright(result.shape.uv, upright_direction(chart, result.shape.uv, options));
  result.shape.status = ShapeStatus::stalled;  // until its energy is least for the cloth
  if (!result.shape.injectivity) result.shape.injectivity = injectivity_of(chart, result.shape.uv);
  if (result.shape.injectivity == Injectivity::none) return;
  if (stop.is_stopped() || !budget.allows()) return;
  if (std::optional<RefinedShape> shape = ClothRefinement(chart, options, stop).refine(result.shape, budget)) {
    shape->iterations += result.shape.iterations;
    result.shape = std::move(*shape);
  }
  result.factorizations = budget.spent();
}

std::optional<RefineResult> refine_injective(const Chart& chart, const InternalOptions& options, RefineBudget& budget,
                                             const StopToken& stop) {
  RefineResult refined = refine_chart(chart, options, budget, stop);
  if (!refined.shape.is_exact() || injectivity_of(chart, refined.shape.uv) != Injectivity::global) return std::nullopt;
  if (options.cloth) refine_cloth(chart, options, budget, stop.in("shape"), refined);
  return refined;
}

}  // namespace wirewarp
