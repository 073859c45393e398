// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/lies_flat.h"

#include "surface/charts/folded_faces.h"
#include "surface/charts/isoperimetric.h"

namespace wirewarp {
namespace {

/// A piece that takes longer is better cut. Proposed seams fix all of 43 garments, shoes, cushions and toys with any
/// limit from 20 (94 pieces in the end) to 100 (92 pieces).
constexpr int kMaxFactorizations = 40;

}  // namespace

bool lies_flat(const Chart& chart, const InternalOptions& options, const StopToken& stop) {
  if (chart.error || is_outline_too_short(chart)) return false;
  InternalOptions brief = options;
  brief.max_factorizations = kMaxFactorizations;  // replaces the user's limit, which is for the piece itself
  brief.cloth.reset();                            // a chart has a flat shape in every fabric or in none
  const Solution found = refine_chart(chart, brief, stop);
  return found.is_exact() && find_folded_faces(chart.mesh, found.shape.uv).empty();
}

}  // namespace wirewarp
