// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>
#include <functional>
#include <memory>
#include <utility>

namespace wirewarp {

/// The caller told a chart's solver to stop.
class Stopped : public std::exception {
 public:
  const char* what() const noexcept override { return "stopped"; }
};

/// Asks whether to go on, in the stage at hand, and never again after a no. Copies share that memory. Of one thread.
class StopToken {
 public:
  using Question = std::function<bool(const char* stage)>;

  StopToken() = default;  // nobody stops it
  explicit StopToken(Question may_go_on) : state_(std::make_shared<State>(State{std::move(may_go_on), false})) {}

  /// The token of another stage.
  StopToken in(const char* stage) const {
    StopToken token = *this;
    token.stage_ = stage;
    return token;
  }

  /// False: stop with what there is.
  bool may_go_on() const {
    if (state_ && !state_->is_stopped) state_->is_stopped = !state_->may_go_on(stage_);
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
    Question may_go_on;
    bool is_stopped;
  };
  std::shared_ptr<State> state_;
  const char* stage_ = "";
};

}  // namespace wirewarp
