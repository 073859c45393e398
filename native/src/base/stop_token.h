// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <exception>
#include <functional>
#include <memory>
#include <utility>

namespace wirewarp {

/// Thrown if the caller stops the solver of a chart.
class Stopped : public std::exception {
 public:
  const char* what() const noexcept override { return "stopped"; }
};

/// Asks the caller whether to go on, and remembers the first "no". All copies of a token remember it. Several threads
/// may use one token if its function may be called from several threads.
class StopToken {
 public:
  using Question = std::function<bool(const char* stage)>;

  StopToken() = default;  // never stops
  explicit StopToken(Question may_go_on) : state_(std::make_shared<State>(std::move(may_go_on))) {}

  /// Returns a copy of this token that names another stage to the caller.
  StopToken in(const char* stage) const {
    StopToken token = *this;
    token.stage_ = stage;
    return token;
  }

  /// Returns false if the work should stop with the result so far.
  bool may_go_on() const {
    if (state_ && !state_->is_stopped && !state_->may_go_on(stage_)) state_->is_stopped = true;
    return !is_stopped();
  }

  /// Throws Stopped if the work should stop. Use it if there is no result to keep.
  void check() const {
    if (!may_go_on()) throw Stopped();
  }

  /// Returns whether the caller has stopped, without asking again.
  bool is_stopped() const { return state_ && state_->is_stopped; }

 private:
  struct State {
    explicit State(Question question) : may_go_on(std::move(question)) {}
    const Question may_go_on;
    std::atomic<bool> is_stopped{false};
  };
  std::shared_ptr<State> state_;
  const char* stage_ = "";
};

}  // namespace wirewarp
