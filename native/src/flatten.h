// SPDX-License-Identifier: GPL-3.0-or-later
// What flatten() is made of, for searches and tests that need more than it returns.
#pragma once

#include "base/internal_options.h"
#include "base/stop_token.h"
#include "surface/charts/chart.h"
#include "surface/mesh/edge_table.h"

namespace wirewarp {

/// Throws FlattenError where flatten() refuses the whole input. The table refers to the input's faces.
EdgeTable check_request(const FlattenInput& input, const Options& options);

/// flatten() with such options; the same ones in all runs with one cache.
FlattenResult flatten_with(const FlattenInput& input, const InternalOptions& options, const Progress& progress = {},
                           Cache* cache = nullptr);

/// What flatten() makes of these charts of an input in the middle of its material. The token is polled in this thread.
/// Throws Stopped.
FlattenResult flatten_charts(Charts charts, const FlattenInput& input, const InternalOptions& options,
                             const StopToken& stop);

}  // namespace wirewarp
