// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

namespace wirewarp {

/// The factorizations of Newton systems that all starts of a chart may take together. Those of its coarser mesh and of
/// the chart with slits sewn up count like its own.
class RefineBudget {
 public:
  explicit RefineBudget(int max_factorizations) : left_(max_factorizations) {}

  /// At most so many of another budget, and counted there too. That must outlive this one.
  RefineBudget(RefineBudget& whole, int max_factorizations)
      : whole_(&whole), left_(std::min(max_factorizations, whole.left_)) {}

  RefineBudget(const RefineBudget&) = delete;
  RefineBudget& operator=(const RefineBudget&) = delete;

  int left() const { return left_; }
  int spent() const { return spent_; }

  /// Whether so many may be spent; remembers a no, in the whole budget too if that is what says no.
  bool allows(int factorizations = 1) {
    if (whole_) whole_->allows(factorizations);
    ran_out_ = ran_out_ || left_ < factorizations;
    return left_ >= factorizations;
  }

  /// More would have been spent.
  bool ran_out() const { return ran_out_; }

  void spend(int factorizations) {
    left_ -= factorizations;
    spent_ += factorizations;
    if (whole_) whole_->spend(factorizations);
  }

 private:
  RefineBudget* whole_ = nullptr;
  int left_;
  int spent_ = 0;
  bool ran_out_ = false;
};

}  // namespace wirewarp
