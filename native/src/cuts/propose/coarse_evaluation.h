// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "base/internal_options.h"
#include "base/stop_token.h"
#include "cuts/feasibility/cut_mask.h"
#include "surface/charts/chart.h"

namespace wirewarp {

/// The coarse evaluation of cuts of one chart, mostly of a coarse copy: a few Newton steps. In any thread.
class CoarseEvaluation {
 public:
  /// The chart must outlive the trials. Throws Stopped.
  CoarseEvaluation(const Chart& chart, const InternalOptions& options, const StopToken& stop);

  /// E of Eq. (4) of the chart as it is, by the refined method, scene units squared; infinite where it does not lie
  /// flat.
  double energy_uncut() const { return uncut_; }

  /// The same for the chart cut along some of its edges. Throws Stopped.
  double energy_when_cut(const CutMask& cut, const StopToken& stop) const;

 private:
  const Chart& chart_;
  InternalOptions options_;
  double uncut_ = 0;
  std::optional<Positions2> start_;  // the uncut shape, where that is near those of the cut chart
};

}  // namespace wirewarp
