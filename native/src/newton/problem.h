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

/// The goal of a refinement.
struct Stage {
  const Cloth* cloth = nullptr;                 // f has the energy of this cloth; null: f has the shape error
  const TargetLengths* lengths = nullptr;       // null: nominal lengths and free rotation of the layout
  Injectivity injectivity = Injectivity::none;  // of all iterates, including the start
  Target target = Target::minimum;
};

/// A chart with the quantities that its starts and stages share, each computed once. Only one thread may use a
/// problem.
class Problem {
 public:
  /// The chart must outlive the problem. fairness: Options::fairness.
  Problem(const Chart& chart, double fairness);

  /// Makes a problem with the lengths and angles of this network instead of the chart's own. All slits count as
  /// ordinary parts of the outline, because sewing would measure the chart's own lengths again.
  Problem(const Chart& chart, HeldNetwork network, double fairness);

  const Chart& chart() const { return chart_; }
  const HeldNetwork& network() const { return network_; }
  double fairness() const { return fairness_; }

  /// Returns the area of the chart's surface.
  double area() const { return area_; }

  const std::vector<Slit>& slits();

  /// Returns the free ARAP flattening after kFreeSteps steps, from the chart if it is stored there. Throws Stopped and
  /// FactorizationFailed.
  const Positions2& free_map(const StopToken& stop);

  /// Return c and f of a stage. layout: one row per chart vertex. It may be empty if the stage fixes no rotation and
  /// forbids no overlaps.
  LengthConstraints constraints(const Stage& stage, const Positions2& layout = {}) const;
  FairShapeError objective(const Stage& stage, const Positions2& layout = {}) const;

 private:
  const Chart& chart_;
  HeldNetwork network_;
  double fairness_;
  double area_;
  std::optional<std::vector<Slit>> slits_;
  std::optional<Positions2> free_map_;
};

}  // namespace wirewarp
