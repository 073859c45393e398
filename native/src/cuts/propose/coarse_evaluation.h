// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "base/internal_options.h"
#include "base/stop_token.h"
#include "cuts/feasibility/cut_mask.h"
#include "surface/charts/chart.h"

namespace wirewarp {

/// A chart with few faces, for quick evaluations of cuts. Coarsening drops super-elastic wires.
struct CoarseCopy {
  Chart chart;
  std::vector<VertexHandle> fine_vertex;  // vertex of the original chart at each coarse vertex
};

/// Returns a copy with about half as many faces as the requested number `faces`. Returns the chart itself if it has few
/// faces or cannot be coarsened. Throws Stopped.
CoarseCopy coarse_copy(const Chart& chart, double faces, const StopToken& stop);

/// Evaluates cuts of a chart by a few Newton steps. The chart is usually a coarse copy. May be used in any thread.
class CoarseEvaluation {
 public:
  /// The chart must outlive this object. Throws Stopped.
  CoarseEvaluation(const Chart& chart, const InternalOptions& options, const StopToken& stop);

  /// Returns the energy of the uncut chart: E of Eq. (4) by the refined method, in scene units squared. It is infinite
  /// if the chart has no flat shape.
  double energy_uncut() const { return uncut_; }

  /// Returns the energy of the chart with a cut, measured like energy_uncut(). Throws Stopped.
  double energy_when_cut(const CutMask& cut, const StopToken& stop) const;

 private:
  const Chart& chart_;
  InternalOptions options_;
  double uncut_ = 0;
  std::optional<Positions2> start_;  // the uncut shape, if it is near the shapes of cut charts
};

}  // namespace wirewarp
