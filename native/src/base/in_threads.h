// SPDX-License-Identifier: GPL-3.0-or-later
// Independent work on several threads. The assignment of work to threads never changes a result.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <future>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include "base/stop_token.h"

namespace wirewarp {

/// Returns the number of cores this thread may use, at least 1.
std::size_t num_cores();

/// While an object of this class exists, num_cores() is 1 on its thread. Use the class if every core is already busy,
/// so that more threads would only compete.
class OnOneCore {
 public:
  OnOneCore();
  ~OnOneCore();
  OnOneCore(const OnOneCore&) = delete;
  OnOneCore& operator=(const OnOneCore&) = delete;

 private:
  bool was_on_one_core_;
};

inline bool has_second_core() { return num_cores() > 1; }

/// Starts a thread. Returns nullopt if the system allows no more threads.
template <typename Work>
std::optional<std::future<void>> begin_thread(const Work& work) {
  try {
    return std::async(std::launch::async, work);
  } catch (const std::system_error&) {
    return std::nullopt;
  }
}

/// Calls work(0) to work(count - 1) on at most num_threads threads, with work(0) on the calling thread. While the
/// calling thread waits, it calls meanwhile() every 20 ms. After an exception, no more work starts, and the exception
/// is rethrown.
template <typename Work>
void run_in_threads(
    std::size_t count, std::size_t num_threads, const Work& work, const std::function<void()>& meanwhile = [] {}) {
  std::atomic<std::size_t> next{1};
  std::atomic<bool> has_failed{false};
  const auto begin_at = [&](std::size_t i) {
    try {
      for (; i < count && !has_failed; i = next++) work(i);
    } catch (...) {
      has_failed = true;
      throw;
    }
  };
  std::vector<std::future<void>> others;
  while (others.size() + 1 < std::min(count, num_threads)) {
    std::optional<std::future<void>> other = begin_thread([&] { begin_at(next++); });
    if (!other) break;  // if no thread can be started, the existing threads do all the work
    others.push_back(std::move(*other));
  }
  begin_at(0);
  for (std::future<void>& other : others) {
    while (other.wait_for(std::chrono::milliseconds(20)) == std::future_status::timeout) meanwhile();
    other.get();
  }
}

/// Calls work(0) to work(count - 1) on all cores. Inside a call, num_cores() is 1. Polls the token while waiting, so
/// that the caller can show progress.
template <typename Work>
void run_on_all_cores(std::size_t count, const StopToken& stop, const Work& work) {
  run_in_threads(
      count, num_cores(),
      [&](std::size_t i) {
        const OnOneCore on_one_core;
        work(i);
      },
      [&] { stop.may_go_on(); });
}

}  // namespace wirewarp
