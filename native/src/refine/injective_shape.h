// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes that neither turn over nor cover themselves, where the quick way ends with one that does.
#pragma once

#include "refine/refine_budget.h"

namespace wirewarp {

/// How injective a layout of the chart is, one row per vertex.
Injectivity injectivity_of(const Chart& chart, const Positions2& uv);

/// The least distorted shape with exact lengths and that injectivity, reached through nothing but such shapes: from the
/// free ARAP shape where that has it, else from the embedding on a circle. Not exact where it is not found. network: of
/// all wires but super-elastic ones.
RefinedShape refine_injectively(const Chart& chart, const WireNetwork& network, Injectivity injectivity,
                                RefineBudget& budget);

/// The shape, if its lengths are exact and it is injective; else the most injective one that is found: flips are
/// mended first, then what overlaps is moved apart.
RefinedShape make_injective(const Chart& chart, const WireNetwork& network, RefinedShape shape, RefineBudget& budget);

}  // namespace wirewarp
