// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "network/wire_network.h"

namespace wirewarp {

/// A chart to refine: what f and the lengths are made of.
struct RefineTask {
  const Chart& chart;
  const HeldNetwork& network;
  double fairness;  // shortest wiggle of wires that is left alone, over the square root of the area
};

}  // namespace wirewarp
