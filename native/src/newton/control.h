// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "base/stop_token.h"

namespace wirewarp {

/// Counts factorizations of Newton systems against a limit. All starts of a chart share one budget, including the
/// starts of its coarser copy and of the copy with sewn slits.
class Budget {
 public:
  explicit Budget(int max_factorizations) : left_(max_factorizations) {}

  /// Makes a part of another budget, for at most max_factorizations. Spending counts in both budgets. The whole must
  /// outlive the part.
  Budget(Budget& whole, int max_factorizations) : whole_(&whole), left_(std::min(max_factorizations, whole.left_)) {}

  Budget(const Budget&) = delete;
  Budget& operator=(const Budget&) = delete;

  int left() const { return left_; }
  int spent() const { return spent_; }

  /// Returns whether another factorization may be spent. If not, ran_out() is true from then on. The same holds for
  /// ran_out() of the whole budget.
  bool allows() {
    if (whole_) whole_->allows();
    ran_out_ = ran_out_ || left_ < 1;
    return left_ >= 1;
  }

  bool ran_out() const { return ran_out_; }

  void spend(int factorizations) {
    left_ -= factorizations;
    spent_ += factorizations;
    if (whole_) whole_->spend(factorizations);
  }

 private:
  Budget* whole_ = nullptr;
  int left_;
  int spent_ = 0;
  bool ran_out_ = false;
};

/// The two limits that can end a solver early: its budget, and a stop by the caller.
struct Control {
  Budget& budget;
  StopToken stop = {};  // polled before each factorization

  /// Returns this control for another stage of progress.
  Control in(const char* stage) const { return {budget, stop.in(stage)}; }

  bool may_go_on() const { return budget.allows() && stop.may_go_on(); }
};

}  // namespace wirewarp
