// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "base/internal_options.h"
#include "base/stop_token.h"
#include "cuts/feasibility/cut_mask.h"
#include "surface/charts/chart.h"

namespace wirewarp {

/// Evaluates cuts of a chart, which is usually a coarse copy, by a few Newton steps. May be used in any thread.
class CoarseEvaluation {
 public:
  /// The chart must outlive this object. Throws Stopped.
  CoarseEvaluation(const Chart& chart, const InternalOptions& options, const StopToken& stop);

  /// Returns E of Eq. (4) of the uncut chart by the refined method, in scene units squared; infinite if it has no flat
  /// shape.
  double energy_uncut() const { return uncut_; }

  /// Returns this energy for the chart with a cut. Throws Stopped.
  double energy_when_cut(const CutMask& cut, const StopToken& stop) const;

 private:
  const Chart& chart_;
  InternalOptions options_;
  double uncut_ = 0;
  std::optional<Positions2> start_;  // the uncut shape, if it is near the shapes of cut charts
};

}  // namespace wirewarp
