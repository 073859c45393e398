// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <future>
#include <thread>
#include <vector>

namespace wirewarp {

/// Calls work(0) to work(count - 1), begun in this order, on as many threads as there are cores; the calling thread is
/// one of them, and calls meanwhile() from time to time once there is nothing left to begin.
template <typename Work, typename Meanwhile>
void on_all_cores(std::size_t count, const Work& work, const Meanwhile& meanwhile) {
  std::atomic<std::size_t> next{0};
  const auto take_what_is_left = [&] {
    for (std::size_t i = next++; i < count; i = next++) work(i);
  };
  const std::size_t num_threads = std::min<std::size_t>(count, std::thread::hardware_concurrency());
  std::vector<std::future<void>> others;
  while (others.size() + 1 < num_threads) others.push_back(std::async(std::launch::async, take_what_is_left));
  take_what_is_left();
  for (std::future<void>& other : others) {
    while (other.wait_for(std::chrono::milliseconds(20)) == std::future_status::timeout) meanwhile();
    other.get();
  }
}

}  // namespace wirewarp
