// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes that neither turn over nor cover themselves, where the quick way ends with one that does.
#pragma once

#include <optional>

#include "refine/refine_shape.h"

namespace wirewarp {

/// How injective a layout of the chart is, one row per vertex.
Injectivity injectivity_of(const Chart& chart, const Positions2& uv);

/// A start with exact lengths and the injectivity of the limits, reached through nothing but such shapes: from the free
/// ARAP shape where that has it, else from the embedding on a circle. None where it is not found. stop: asked in the
/// stages "start" and "shape". Throws Stopped and FactorizationFailed.
std::optional<RefinementStart> reach_injectively(const RefineTask& task, const RefinementLimits& limits);

/// Puts the least distorted injective shape, or the most injective one that is found, in place of an exact shape that
/// is not: flips are mended first, then what overlaps is moved apart. False where the shape stays. Stopped, it stays.
bool make_injective(const RefineTask& task, const RefinementLimits& limits, RefinedShape& shape);

}  // namespace wirewarp
