// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of flatten(), for searches and tests that need more than the result of flatten().
#pragma once

#include "base/internal_options.h"
#include "base/stop_token.h"
#include "surface/charts/chart.h"
#include "surface/mesh/edge_table.h"

namespace wirewarp {

/// Throws FlattenError if flatten() refuses the whole input. The input must outlive the returned table.
EdgeTable check_request(const FlattenInput& input, const Options& options);

/// Does the same as flatten(), with internal options. All runs with one cache must use the same internal options.
FlattenResult flatten_with(const FlattenInput& input, const InternalOptions& options, const Progress& progress = {},
                           Cache* cache = nullptr);

/// Flattens these charts. If the material has a thickness, `input` is its middle surface (see move_to_middle()). The
/// token is polled only in the calling thread. Throws Stopped.
FlattenResult flatten_charts(Charts charts, const FlattenInput& input, const InternalOptions& options,
                             const StopToken& stop);

}  // namespace wirewarp
