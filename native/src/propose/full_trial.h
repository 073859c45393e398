// SPDX-License-Identifier: GPL-3.0-or-later
// What flatten() makes of a piece that is cut.
#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "charts/chart.h"
#include "internal_options.h"
#include "wirewarp/cache.h"

namespace wirewarp {

struct PieceFigures {
  double energy = 0;                  // over the 3D area
  double strain = 0;                  // DartProposal::strain
  double area = 0;                    // in 3D, scene units squared
  std::optional<FlattenError> error;  // of one of the pieces
};

/// Of those pieces of a result that are made of faces of a chart of its input.
PieceFigures figures_of(const FlattenResult& result, const Chart& chart, const Options& options);

FlattenInput with_seams(FlattenInput input, const std::vector<VertexPair>& edges);

/// Flattens one input again and again with a cut more or less.
class FullTrials {
 public:
  /// go_on: asked in any thread; false ends a run with Stopped.
  FullTrials(const FlattenInput& input, const Options& options, const std::function<bool()>& go_on);

  /// In any thread.
  FlattenResult run(const std::vector<VertexPair>& cut);

  /// All later runs have these cuts, and no others taken before.
  void take(std::vector<VertexPair> cuts) { taken_ = std::move(cuts); }

  const InternalOptions& options() const { return options_; }

 private:
  const FlattenInput& input_;
  InternalOptions options_;
  const std::function<bool()>& go_on_;
  std::vector<VertexPair> taken_;
  Cache cache_;  // of the other pieces
};

}  // namespace wirewarp
