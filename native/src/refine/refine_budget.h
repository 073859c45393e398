// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <functional>
#include <limits>

#include "progress_report.h"
#include "refine/refine_shape.h"
#include "wirewarp/options.h"

namespace wirewarp {

inline constexpr int kNoLimit = std::numeric_limits<int>::max();

/// The starts of one chart, and of it with slits sewn up: they share the limits, and are counted together.
class RefineBudget {
 public:
  /// go_on must outlive the attempts.
  RefineBudget(const Options& options, const GoOn& go_on)
      : fairness_(options.fairness), max_factorizations_(options.max_factorizations), go_on_(go_on) {}

  double fairness() const { return fairness_; }
  bool was_stopped() const { return was_stopped_; }
  bool ran_out() const { return was_stopped_ || factorizations_ >= max_factorizations_; }
  int factorizations() const { return factorizations_; }

  /// Asks in a stage, and not again after a no.
  std::function<bool()> asking(const char* stage) {
    return [this, stage] {
      was_stopped_ = was_stopped_ || !go_on_(stage);
      return !was_stopped_;
    };
  }

  /// What is left, for a shape with that injectivity.
  RefinementLimits limits(int max_factorizations = kNoLimit, Injectivity injectivity = Injectivity::none) {
    return {std::min(max_factorizations, max_factorizations_ - factorizations_), asking("shape"), injectivity};
  }

  void count(int factorizations) { factorizations_ += factorizations; }

  RefinedShape refine(const Chart& chart, const WireNetwork& network, const RefinementStart& start,
                      int max_factorizations = kNoLimit, Injectivity injectivity = Injectivity::none) {
    RefinedShape shape = refine_shape(chart, network, fairness_, start, limits(max_factorizations, injectivity));
    count(shape.factorizations);
    return shape;
  }

 private:
  double fairness_;
  int max_factorizations_;
  const GoOn& go_on_;
  int factorizations_ = 0;
  bool was_stopped_ = false;
};

}  // namespace wirewarp
