// SPDX-License-Identifier: GPL-3.0-or-later
#include "refine/lies_flat.h"

#include <algorithm>
#include <stdexcept>

#include "feasibility/check_outline.h"
#include "feasibility/folded_faces.h"

namespace wirewarp {
namespace {

/// Three times what strongly curved pieces take.
constexpr int kMaxFactorizations = 40;

}  // namespace

bool lies_flat(const Chart& chart, const Options& options, const GoOn& go_on, const Tuning& tuning) {
  if (chart.error || is_outline_too_short(chart)) return false;
  Options brief = options;
  brief.max_factorizations = std::min(options.max_factorizations, kMaxFactorizations);
  try {
    const RefinedShape shape = refine_chart(chart, brief, go_on, tuning).shape;
    return shape.is_exact && find_folded_faces(chart.mesh, shape.uv).empty();
  } catch (const std::domain_error&) {  // a factorization broke down
    return false;
  }
}

}  // namespace wirewarp
