// SPDX-License-Identifier: GPL-3.0-or-later
#include "cuts/propose/coarse_evaluation.h"

#include <cmath>
#include <limits>
#include <utility>

#include "cuts/feasibility/cut_apart.h"
#include "energy/shape_error.h"
#include "newton/coarsen/coarse_chart.h"
#include "newton/minimize.h"
#include "newton/refine_chart.h"
#include "surface/charts/folded_faces.h"
#include "surface/mesh/geometry.h"

namespace wirewarp {
namespace {

constexpr double kHasNoFlatShape = std::numeric_limits<double>::infinity();

/// Largest number of factorizations per piece. Good cuts take 3 to 8. Pieces that take more have wires that almost
/// contradict one another.
constexpr int kMaxFactorizations = 20;

/// Cut pieces start from the uncut shape if its energy over area is below this value, which halves the time.
/// - Above: every third evaluation of a hat (0.04) and a cushion (0.26) leads to folds
/// - Below: the best cuts of seven panels of garments (0.0006 to 0.01) lead to no folds
constexpr double kNearFlat = 0.02;

InternalOptions brief(InternalOptions options) {
  options.max_factorizations = kMaxFactorizations;
  options.makes_injective = false;  // cuts that fold a piece are bad, and fixing folds takes as long as ten evaluations
  options.target = Target::rough;
  options.cloth.reset();  // a fabric doubles the time of an evaluation, and exact evaluations use it later
  return options;
}

double energy_of(const Chart& piece, const Solution& found) {
  const bool lies_flat = found.is_exact() && !has_folds(piece.mesh, found.shape.uv);
  return lies_flat ? ShapeError(piece).energy(found.shape.uv) : kHasNoFlatShape;
}

}  // namespace

CoarseCopy coarse_copy(const Chart& chart, double faces, const StopToken& stop) {
  const double wanted = std::sqrt(4 / std::sqrt(3.0) * surface_area(chart.mesh) / faces);
  if (wanted < typical_edge_length(chart.mesh) || !can_coarsen(chart)) {
    return {chart, std::vector<VertexHandle>(chart.mesh.vertices_begin(), chart.mesh.vertices_end())};
  }
  CoarseChart coarse = coarsen(chart, build_held_network(chart), wanted, stop);
  CoarseCopy copy{std::move(coarse.chart), {}};
  copy.fine_vertex.resize(copy.chart.mesh.n_vertices());
  for (const VertexHandle v : chart.mesh.vertices()) {
    const CoarsePlace& place = coarse.places[v.idx()];
    if (place.weights[0] == 1) copy.fine_vertex[place.vertices[0]] = v;
  }
  return copy;
}

CoarseEvaluation::CoarseEvaluation(const Chart& chart, const InternalOptions& options, const StopToken& stop)
    : chart_(chart), options_(brief(options)) {
  Solution uncut = refine_chart(chart, options_, stop);
  stop.check();
  uncut_ = energy_of(chart, uncut);
  if (uncut_ < kNearFlat * surface_area(chart.mesh)) start_ = std::move(uncut.shape.uv);
}

double CoarseEvaluation::energy_when_cut(const CutMask& cut, const StopToken& stop) const {
  double energy = 0;
  for (const Chart& piece : cut_apart(chart_, cut)) {
    if (piece.error) return kHasNoFlatShape;
    Solution flat;
    if (start_) {
      const Problem problem(piece, options_.fairness);
      const auto num_rows = static_cast<Eigen::Index>(problem.network().edges.size());
      // The multipliers start at 0, so that the first step opens the cut.
      const Shape start{(*start_)(piece.source_vertex, Eigen::all), {}, Eigen::VectorXd::Zero(num_rows)};
      Budget budget(options_.max_factorizations);
      flat = minimize(problem, {nullptr, nullptr, Injectivity::none, options_.target}, start, {budget, stop});
    }
    if (!flat.is_exact()) flat = refine_chart(piece, options_, stop);
    stop.check();
    energy += energy_of(piece, flat);
  }
  return energy;
}

}  // namespace wirewarp
