// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <future>
#include <thread>
#include <vector>

namespace wirewarp {

/// The processor has a second core for a second thread.
inline bool has_second_core() { return std::thread::hardware_concurrency() > 1; }

/// Calls work(0) to work(num_shares - 1), all but the first in threads of their own if asked for.
template <typename Work>
void run_shares(std::size_t num_shares, bool in_threads, const Work& work) {
  std::vector<std::future<void>> others;
  for (std::size_t share = 1; in_threads && share < num_shares; ++share) {
    others.push_back(std::async(std::launch::async, work, share));
  }
  for (std::size_t share = 0; share < (in_threads ? 1 : num_shares); ++share) work(share);
  for (std::future<void>& other : others) other.get();
}

}  // namespace wirewarp
