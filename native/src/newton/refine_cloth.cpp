// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/refine_cloth.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/planar.h"
#include "newton/injective_shape.h"
#include "newton/newton_constants.h"
#include "newton/next_stage.h"
#include "surface/orientation/upright_direction.h"

namespace wirewarp {
namespace {

// Angle between two compared directions. The energy of small strains has four waves per turn at most, so 18 directions
// are on each wave.
constexpr double kSpacing = kPi / 36;
constexpr std::size_t kBestStarts = 3;  // enough, because the energy of most pieces has one minimum in a quarter turn
constexpr int kMaxTurns = 15;           // the samples take 3 to 6 turns
constexpr double kShorter = 4;  // divides the angle of a turn that fails to lower the energy, as in a line search

/// Returns a layout rotated about the origin, counter-clockwise.
Positions2 turned(const Positions2& uv, double angle) {
  return uv * Eigen::Rotation2Dd(angle).toRotationMatrix().transpose();
}

/// Returns the angle after which the energy of a turned cloth repeats. If weft and warp are equally stiff, this is a
/// quarter turn, which exchanges them.
double period(const Cloth& cloth) { return cloth.weft == cloth.warp ? kPi / 2 : kPi; }

class ClothRefinement {
 public:
  /// injectivity: injectivity of the shape without a fabric. pair: vertices between which the direction is fixed.
  ClothRefinement(Problem& problem, const InternalOptions& options, const Control& control, Injectivity injectivity,
                  const VertexPair& pair)
      : problem_(problem), options_(options), control_(control), injectivity_(injectivity), pair_(pair) {}

  Solution minimize_in_direction(const Shape& start);
  Solution minimize_turning(const Shape& upright);

  /// Returns whether a shape is exact and as injective as the shape without a fabric. This matters more than a
  /// low energy.
  bool is_sound(const Solution& found) const { return found.is_exact() && found.injectivity >= injectivity_; }

 private:
  /// A layout rotated to a minimum of its energy.
  struct Turn {
    Positions2 uv;
    double energy;     // f over the area
    double curvature;  // second derivative of energy with respect to the angle
  };

  std::vector<Turn> best_turns(const Positions2& uv) const;
  TargetLengths lengths_in_direction_of(const Positions2& uv) const { return {{hold_direction(pair_, uv)}, {}}; }
  double slope_of(const Shape& shape) const;
  bool may_go_on() const { return !control_.stop.is_stopped() && control_.budget.allows(); }

  Problem& problem_;
  const InternalOptions& options_;
  const Control control_;
  const Injectivity injectivity_;
  const VertexPair pair_;
};

/// Minimizes with the direction of the start. If the piece overlaps itself and did not before, minimizes again with a
/// barrier against overlaps.
Solution ClothRefinement::minimize_in_direction(const Shape& start) {
  const TargetLengths lengths = lengths_in_direction_of(start.uv);
  Solution held;
  for (const Injectivity injectivity : {Injectivity::local, Injectivity::global}) {
    held = minimize_next(problem_, {&*options_.cloth, &lengths, injectivity, options_.target}, start, control_);
    held.injectivity = injectivity_of(problem_.chart(), held.shape.uv);
    if (held.injectivity >= injectivity_ || !may_go_on()) break;
  }
  return held;
}

/// Returns the derivative of f over the area with respect to the fixed angle. The multiplier is the derivative with
/// respect to n·d, which changes by |d| dθ if n turns by dθ.
double ClothRefinement::slope_of(const Shape& shape) const {
  const double length = (shape.uv.row(pair_[1]) - shape.uv.row(pair_[0])).norm();
  return shape.multipliers[shape.multipliers.size() - 1] * length / problem_.area();
}

/// Returns the rotated layouts at the lowest minima of the energy over the angle, the lowest first.
std::vector<ClothRefinement::Turn> ClothRefinement::best_turns(const Positions2& uv) const {
  const FairShapeError objective = problem_.objective({&*options_.cloth});
  const auto count = static_cast<int>(std::lround(period(*options_.cloth) / kSpacing));
  std::vector<double> energy;
  for (int k = 0; k < count; ++k) energy.push_back(objective.value(turned(uv, k * kSpacing)) / problem_.area());
  std::vector<Turn> turns;
  for (int k = 0; k < count; ++k) {
    const double before = energy[(k + count - 1) % count], after = energy[(k + 1) % count];
    if (energy[k] > before || energy[k] >= after) continue;
    turns.push_back({turned(uv, k * kSpacing), energy[k], (before - 2 * energy[k] + after) / (kSpacing * kSpacing)});
  }
  if (turns.empty()) turns.push_back({uv, energy[0], 0});  // all directions have the same energy
  std::stable_sort(turns.begin(), turns.end(), [](const Turn& a, const Turn& b) { return a.energy < b.energy; });
  turns.resize(std::min(turns.size(), kBestStarts));
  return turns;
}

/// Minimizes for a few fixed directions, and takes Newton steps in the angle from the best of these shapes.
Solution ClothRefinement::minimize_turning(const Shape& upright) {
  Solution best;
  double curvature = 0;
  for (const Turn& turn : best_turns(upright.uv)) {
    if (!may_go_on()) break;
    Solution held = minimize_in_direction({turn.uv, {}, upright.multipliers});
    if (!is_sound(held) || (is_sound(best) && held.objective >= best.objective)) continue;
    best = std::move(held);
    curvature = turn.curvature;
  }
  if (!is_sound(best)) return best;
  const double longest = kSpacing;
  for (int i = 0; i < kMaxTurns; ++i) {
    const double slope = slope_of(best.shape);
    double angle = curvature > 0 ? -slope / curvature : -std::copysign(longest, slope);
    angle = std::clamp(angle, -longest, longest);
    if (std::abs(slope * angle) < NewtonConstants::worthwhile * best.objective || !best.is_converged()) return best;
    if (!may_go_on()) break;
    Solution trial = minimize_in_direction({turned(best.shape.uv, angle), {}, best.shape.multipliers});
    if (trial.is_converged() && is_sound(trial) && trial.objective < best.objective) {
      const double change = (slope_of(trial.shape) - slope) / angle;
      curvature = change > 0 ? change : 0;
      best = std::move(trial);
    } else {
      curvature = kShorter * std::abs(slope / angle);
    }
  }
  best.status = SolutionStatus::stalled;
  return best;
}

/// Turns the layout by whole periods of its energy, so that its up direction is as near to +y as possible.
void turn_up(const Chart& chart, const InternalOptions& options, Positions2& uv) {
  Eigen::Vector2d up = upright_direction(chart, uv, options);
  if (period(*options.cloth) < kPi && std::abs(up.x()) > std::abs(up.y())) {
    uv = turned(uv, kPi / 2);
    up = {-up.y(), up.x()};
  }
  if (up.y() < 0) uv *= -1;
}

}  // namespace

GrainRow hold_upright(const Chart& chart, const Positions2& uv, const Options& options) {
  return hold_direction(upright_pair(chart, uv, options), uv);
}

void refine_cloth(Problem& problem, const InternalOptions& options, const Control& control, Solution& solution) {
  const Chart& chart = problem.chart();
  stand_upright(solution.shape.uv, upright_direction(chart, solution.shape.uv, options));
  solution.status = SolutionStatus::stalled;  // not converged until the fabric's energy is minimal
  if (!solution.injectivity) solution.injectivity = injectivity_of(chart, solution.shape.uv);
  if (solution.injectivity == Injectivity::none) return;
  if (control.stop.is_stopped() || !control.budget.allows()) return;
  ClothRefinement refinement(problem, options, control, *solution.injectivity,
                             upright_pair(chart, solution.shape.uv, options));
  const Eigen::VectorXd& forces = solution.shape.multipliers;
  Shape start{solution.shape.uv, {}, Eigen::VectorXd(forces.size() + 1)};
  start.multipliers << forces, 0;
  const bool is_turned = options.orientation == Orientation::best;
  Solution found = is_turned ? refinement.minimize_turning(start) : refinement.minimize_in_direction(start);
  if (!refinement.is_sound(found)) return;
  if (is_turned) turn_up(chart, options, found.shape.uv);
  found.iterations += solution.iterations;
  found.start = solution.start;
  solution = std::move(found);
}

}  // namespace wirewarp
