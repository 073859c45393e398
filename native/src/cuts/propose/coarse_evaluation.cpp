// SPDX-License-Identifier: GPL-3.0-or-later
#include "cuts/propose/coarse_evaluation.h"

#include <limits>
#include <utility>

#include "cuts/feasibility/cut_apart.h"
#include "energy/shape_error.h"
#include "newton/refine_chart.h"
#include "surface/charts/folded_faces.h"
#include "surface/mesh/geometry.h"

namespace wirewarp {
namespace {

constexpr double kDoesNotLieFlat = std::numeric_limits<double>::infinity();

/// Good cuts take 3 to 8; pieces that take many have wires that hardly fit.
constexpr int kMaxFactorizations = 20;

/// Energy of the uncut shape over its area, below which the cut pieces start from it, in half the time that the starts
/// of refine_chart() take. On a hat (.04) and a cushion (.26) it leads to folds in every third trial, on seven panels
/// of garments (.0006 to .01) in none of the best.
constexpr double kNearFlat = 0.02;

InternalOptions brief(InternalOptions options) {
  options.max_factorizations = kMaxFactorizations;
  options.mends_folds = false;  // a cut that folds the piece is not a good one, and to fix it takes as long as ten
  options.target = Target::rough;
  options.cloth.reset();  // takes about twice as long, and exact evaluations decide
  return options;
}

double energy_of(const Chart& piece, const RefinedShape& shape) {
  const bool lies_flat = shape.is_exact() && find_folded_faces(piece.mesh, shape.uv).empty();
  return lies_flat ? ShapeError(piece).energy(shape.uv) : kDoesNotLieFlat;
}

/// From the shape of the whole chart: without forces in the wires, so that the first step opens the cut.
RefinedShape refine_from(const Positions2& whole, const Chart& piece, const InternalOptions& options,
                         const StopToken& stop) {
  const HeldNetwork network = build_held_network(piece);
  RefinementStart start(whole(piece.source_vertex, Eigen::all),
                        Eigen::VectorXd::Zero(static_cast<Eigen::Index>(network.edges.size())));
  RefineBudget budget(options.max_factorizations);
  return refine_shape({piece, network, options.fairness, nullptr, options.target}, start, {budget, stop});
}

}  // namespace

CoarseEvaluation::CoarseEvaluation(const Chart& chart, const InternalOptions& options, const StopToken& stop)
    : chart_(chart), options_(brief(options)) {
  RefinedShape shape = refine_chart(chart, options_, stop).shape;
  stop.check();
  uncut_ = energy_of(chart, shape);
  if (uncut_ < kNearFlat * surface_area(chart.mesh)) start_ = std::move(shape.uv);
}

double CoarseEvaluation::energy_when_cut(const CutMask& cut, const StopToken& stop) const {
  double energy = 0;
  for (const Chart& piece : cut_apart(chart_, cut)) {
    if (piece.error) return kDoesNotLieFlat;
    RefinedShape shape;
    if (start_) shape = refine_from(*start_, piece, options_, stop);
    if (!shape.is_exact()) shape = refine_chart(piece, options_, stop).shape;
    stop.check();
    energy += energy_of(piece, shape);
  }
  return energy;
}

}  // namespace wirewarp
