// SPDX-License-Identifier: GPL-3.0-or-later
#include "propose/cut_trial.h"

#include <limits>

#include "arap/shape_error.h"
#include "factorization_failed.h"
#include "feasibility/cut_apart.h"
#include "feasibility/folded_faces.h"
#include "refine/refine_chart.h"

namespace wirewarp {
namespace {

/// Good cuts take 3 to 8; what takes many has wires that hardly fit.
constexpr int kMaxFactorizations = 20;

}  // namespace

double energy_when_cut(const Chart& chart, const CutMask& cut, const InternalOptions& options, const StopToken& stop) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  InternalOptions brief = options;
  brief.max_factorizations = kMaxFactorizations;
  brief.mends_folds = false;  // what folds is no good cut, and to mend it takes as long as ten trials
  brief.aim = Aim::rough;
  brief.cloth.reset();  // with one a trial takes about twice as long, and runs in full decide
  double energy = 0;
  for (const Chart& piece : cut_apart(chart, cut)) {
    if (piece.error) return kInfinity;
    try {
      const RefinedShape shape = refine_chart(piece, brief, stop).shape;
      if (!shape.is_exact || !find_folded_faces(piece.mesh, shape.uv).empty()) return kInfinity;
      energy += ShapeError(piece).energy(shape.uv);
    } catch (const FactorizationFailed&) {
      return kInfinity;
    }
  }
  return energy;
}

}  // namespace wirewarp
