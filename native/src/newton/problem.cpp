// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/problem.h"

#include <utility>

#include "energy/free_boundary_arap.h"
#include "surface/mesh/geometry.h"

namespace wirewarp {

Problem::Problem(const Chart& chart, double fairness)
    : chart_(chart), network_(build_held_network(chart)), fairness_(fairness), area_(surface_area(chart.mesh)) {}

Problem::Problem(const Chart& chart, HeldNetwork network, double fairness)
    : chart_(chart),
      network_(std::move(network)),
      fairness_(fairness),
      area_(surface_area(chart.mesh)),
      slits_(std::in_place) {}

const std::vector<Slit>& Problem::slits() {
  if (!slits_) slits_ = find_slits(chart_);
  return *slits_;
}

const Positions2& Problem::free_map(const StopToken& stop) {
  if (chart_.free_map) return *chart_.free_map;
  if (!free_map_) free_map_ = free_boundary_arap(chart_, kFreeSteps, {}, stop).uv;
  return *free_map_;
}

LengthConstraints Problem::constraints(const Stage& stage, const Positions2& layout) const {
  return LengthConstraints(chart_, network_, stage.lengths, layout);
}

FairShapeError Problem::objective(const Stage& stage, const Positions2& layout) const {
  return FairShapeError(chart_, network_, fairness_, stage.cloth, stage.injectivity, layout);
}

}  // namespace wirewarp
