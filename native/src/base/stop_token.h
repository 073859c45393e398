// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <exception>
#include <functional>
#include <memory>
#include <utility>

namespace wirewarp {

/// The caller stopped the solver of a chart.
class Stopped : public std::exception {
 public:
  const char* what() const noexcept override { return "stopped"; }
};

/// Polls the caller; once the answer was no, it is not asked again. Copies share that memory. Several threads may use
/// one token if its question allows that.
class StopToken {
 public:
  using Question = std::function<bool(const char* stage)>;

  StopToken() = default;  // nobody stops it
  explicit StopToken(Question may_go_on) : state_(std::make_shared<State>(std::move(may_go_on))) {}

  /// The token of another stage.
  StopToken in(const char* stage) const {
    StopToken token = *this;
    token.stage_ = stage;
    return token;
  }

  /// False: stop with what there is.
  bool may_go_on() const {
    if (state_ && !state_->is_stopped && !state_->may_go_on(stage_)) state_->is_stopped = true;
    return !is_stopped();
  }

  /// Where nothing is worth keeping yet: throws Stopped.
  void check() const {
    if (!may_go_on()) throw Stopped();
  }

  /// Without asking.
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
