// SPDX-License-Identifier: GPL-3.0-or-later
#include "refine/refine_cloth.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "factorization_failed.h"
#include "packing/upright_direction.h"
#include "planar.h"
#include "refine/injective_shape.h"
#include "refine/sewn_problem.h"

namespace wirewarp {
namespace {

constexpr int kDirections = 36;  // every 5° of a half turn, after which a cloth is the same again
constexpr std::size_t kBestStarts = 3;

// Rims of a slit that are nearer to one another than this share of the slit's length lie on one another: exact lengths
// leave a millionth of that.
constexpr double kShut = 1e-7;

bool is_shut(const Chart& chart, const Slit& slit, const Positions2& uv) {
  const auto place = [&](VertexHandle v) { return uv.row(v.idx()); };
  double length = 0, gap = 0;
  for (std::size_t i = 0; i < slit.rims.size(); ++i) {
    const HalfedgeHandle rim = slit.rims[i], mate = slit.rims[slit.mate[i]];
    const auto begin = place(chart.mesh.from_vertex_handle(rim)), end = place(chart.mesh.to_vertex_handle(rim));
    length += (end - begin).norm();
    gap = std::max(gap, (place(chart.mesh.to_vertex_handle(mate)) - begin).norm());
  }
  return gap < kShut * length;
}

/// Slits that are shut stay so, sewn: open rims that lie on one another are no smooth point (refine/open_slits.h).
RefinedShape refine_with_shut_slits(const RefineTask& task, const RefinementStart& start,
                                    const RefinementLimits& limits) {
  std::vector<Slit> slits = find_slits(task.chart);
  const auto is_open = [&](const Slit& slit) { return !is_shut(task.chart, slit, start.uv); };
  slits.erase(std::remove_if(slits.begin(), slits.end(), is_open), slits.end());
  std::optional<SewnChart> sewn;
  if (!slits.empty()) sewn = sew(task.chart, slits);
  if (!sewn) return refine_shape(task, start, limits);
  const SewnProblem problem(task, std::move(*sewn));
  const RefinedShape of_sewn = refine_shape(problem.task(), problem.to_sewn(start), limits);
  RefinedShape shape = evaluate_shape(task, problem.to_open(of_sewn));
  shape.converged = of_sewn.converged;
  shape.iterations = of_sewn.iterations;
  return shape;
}

/// Turned about the origin by an angle, counter-clockwise.
Positions2 turned(const Positions2& uv, double angle) {
  return uv * Eigen::Rotation2Dd(angle).toRotationMatrix().transpose();
}

/// The layout turned to where the energy of the cloth is least: the best few of many, as far as they lie in valleys.
std::vector<Positions2> best_turns(const RefineTask& task, const Positions2& uv) {
  const FairShapeError objective(task);
  std::array<double, kDirections> energy;
  const auto turn = [&](int k) { return turned(uv, k * kPi / kDirections); };
  for (int k = 0; k < kDirections; ++k) energy[k] = objective.value(turn(k));
  std::vector<int> valleys;
  for (int k = 0; k < kDirections; ++k) {
    const double before = energy[(k + kDirections - 1) % kDirections], after = energy[(k + 1) % kDirections];
    if (energy[k] <= before && energy[k] < after) valleys.push_back(k);
  }
  if (valleys.empty()) valleys.push_back(0);  // all directions are alike
  std::stable_sort(valleys.begin(), valleys.end(), [&](int j, int k) { return energy[j] < energy[k]; });
  valleys.resize(std::min(valleys.size(), kBestStarts));
  std::vector<Positions2> layouts;
  for (const int k : valleys) layouts.push_back(turn(k));
  return layouts;
}

class ClothRefinement {
 public:
  ClothRefinement(const Chart& chart, const InternalOptions& options, const StopToken& stop)
      : chart_(chart), network_(build_held_network(chart)), options_(options), stop_(stop) {}

  RefinedShape refine(const RefinedShape& upright, RefineBudget& budget);

 private:
  RefineTask task(const ClothOnChart& cloth) const { return {chart_, network_, options_.fairness, &cloth}; }
  RefinedShape refine_held(const RefinedShape& upright, RefineBudget& budget) const;
  RefinedShape refine_free(const RefinedShape& upright, RefineBudget& budget) const;
  RefinedShape refine_from(const RefineTask& task, const RefinementStart& start, Injectivity injectivity,
                           RefineBudget& budget) const;

  const Chart& chart_;
  HeldNetwork network_;
  const InternalOptions& options_;
  StopToken stop_;
};

/// The piece may not cover itself where it did not before: where it does, once more with a barrier against that.
RefinedShape ClothRefinement::refine_from(const RefineTask& task, const RefinementStart& start, Injectivity injectivity,
                                          RefineBudget& budget) const {
  RefinedShape shape = refine_with_shut_slits(task, start, {budget, stop_, Injectivity::local});
  shape.injectivity = injectivity_of(chart_, shape.uv);
  if (shape.injectivity >= injectivity || stop_.is_stopped() || !budget.allows()) return shape;
  shape = refine_with_shut_slits(task, start, {budget, stop_, Injectivity::global});
  shape.injectivity = injectivity_of(chart_, shape.uv);
  return shape;
}

RefinedShape ClothRefinement::refine_held(const RefinedShape& upright, RefineBudget& budget) const {
  const VertexPair pair = upright_pair(chart_, upright.uv, options_);
  const Eigen::Vector2d chord = (upright.uv.row(pair[1]) - upright.uv.row(pair[0])).transpose().normalized();
  const ClothOnChart cloth{*options_.cloth, GrainRow{pair[0], pair[1], {chord.y(), -chord.x()}}};
  Eigen::VectorXd multipliers(upright.multipliers.size() + 1);
  multipliers << upright.multipliers, 0;
  return refine_from(task(cloth), {upright.uv, std::move(multipliers)}, upright.injectivity, budget);
}

RefinedShape ClothRefinement::refine_free(const RefinedShape& upright, RefineBudget& budget) const {
  const ClothOnChart cloth{*options_.cloth, std::nullopt};
  RefinedShape best;
  for (Positions2& uv : best_turns(task(cloth), upright.uv)) {
    RefinedShape shape = refine_from(task(cloth), {std::move(uv), upright.multipliers}, upright.injectivity, budget);
    const bool is_better = shape.injectivity > best.injectivity ||
                           (shape.injectivity == best.injectivity && shape.objective < best.objective);
    if (!best.is_exact || is_better) best = std::move(shape);
    if (stop_.is_stopped() || !budget.allows()) break;
  }
  // Weft and warp are the same after a half turn: what leads up is up.
  if (upright_direction(chart_, best.uv, options_).y() < 0) best.uv *= -1;
  return best;
}

RefinedShape ClothRefinement::refine(const RefinedShape& upright, RefineBudget& budget) {
  return options_.orientation == Orientation::best ? refine_free(upright, budget) : refine_held(upright, budget);
}

}  // namespace

void refine_cloth(const Chart& chart, const InternalOptions& options, const StopToken& stop, RefineResult& result) {
  stand_upright(result.shape.uv, upright_direction(chart, result.shape.uv, options));
  if (result.shape.injectivity == Injectivity::none) return;
  RefineBudget budget(std::max(0, options.max_factorizations - result.factorizations));
  const int iterations = result.shape.iterations;
  result.shape.converged = false;  // until its energy is least for the cloth
  if (stop.is_stopped() || !budget.allows()) return;
  try {
    result.shape = ClothRefinement(chart, options, stop).refine(result.shape, budget);
    result.shape.iterations += iterations;
  } catch (const Stopped&) {  // the shape at hand has exact lengths
  } catch (const FactorizationFailed&) {
  }
  result.factorizations += budget.spent();
}

}  // namespace wirewarp
