// SPDX-License-Identifier: GPL-3.0-or-later
// A chart to flatten under exact lengths, and the stages that its shape goes through.
#pragma once

#include <optional>
#include <vector>

#include "base/internal_options.h"
#include "base/stop_token.h"
#include "energy/fair_shape_error.h"
#include "energy/length_constraints.h"
#include "energy/target_lengths.h"
#include "surface/charts/slits.h"
#include "surface/network/wire_network.h"

namespace wirewarp {

/// What a shape is refined for.
struct Stage {
  const Cloth* cloth = nullptr;                 // whose energy f has; null: the shape error of Eq. (4)
  const TargetLengths* lengths = nullptr;       // null: nominal lengths, and the layout is free to turn
  Injectivity injectivity = Injectivity::none;  // of all iterates, the start included
  Target target = Target::minimum;
};

/// A chart, and what all its starts and stages derive from it, each computed once. Not for several threads.
class Problem {
 public:
  /// The chart must outlive the problem. fairness: Options::fairness.
  Problem(const Chart& chart, double fairness);

  /// With lengths and angles of its own.
  Problem(const Chart& chart, HeldNetwork network, double fairness);

  const Chart& chart() const { return chart_; }
  const HeldNetwork& network() const { return network_; }
  double fairness() const { return fairness_; }

  /// 3D area.
  double area() const { return area_; }

  const std::vector<Slit>& slits();

  /// The free ARAP flattening. Throws Stopped and FactorizationFailed.
  const Positions2& free_map(const StopToken& stop);

  /// c and f of a stage. layout: one row per chart vertex; says how large the chart is, and which parts of its outline
  /// are near each other. It may be empty without a cloth, unless the stage forbids overlaps.
  LengthConstraints constraints(const Stage& stage, const Positions2& layout = {}) const;
  FairShapeError objective(const Stage& stage, const Positions2& layout = {}) const;

 private:
  const Chart& chart_;
  HeldNetwork network_;
  double fairness_;
  double area_;
  std::optional<std::vector<Slit>> slits_;  // once they were asked for
  std::optional<Positions2> free_map_;
};

}  // namespace wirewarp
