// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>

#include "base/in_threads.h"
#include "base/progress_report.h"

namespace wirewarp::test_in_threads {
namespace {

TEST(InThreads, NothingIsBegunOnceWorkHasThrown) {
  for (const std::size_t failing : {0, 1}) {  // in the calling thread, in another one
    std::atomic<bool> has_thrown{false};
    std::atomic<int> done{0};
    std::string thrown;
    try {
      run_in_threads(1000, 2, [&](std::size_t i) {
        if (i == failing) {
          has_thrown = true;
          throw std::runtime_error("work " + std::to_string(i));
        }
        while (!has_thrown) std::this_thread::yield();
        std::this_thread::sleep_for(std::chrono::milliseconds(10));  // the throw may take its time
        ++done;
      });
    } catch (const std::runtime_error& error) {
      thrown = error.what();
    }
    EXPECT_EQ(thrown, "work " + std::to_string(failing));
    EXPECT_LT(done, 999);
  }
}

TEST(ProgressReport, StaysCancelledIfTheCallerWouldGoOn) {
  ProgressReport* report = nullptr;
  const Progress progress = [&](const std::string&, double) {
    report->cancel();  // as another thread may while the caller is asked
    return true;
  };
  ProgressReport cancelled(progress);
  report = &cancelled;
  EXPECT_FALSE(cancelled.go_on("shape", 0));
  EXPECT_TRUE(cancelled.is_cancelled());
}

}  // namespace
}  // namespace wirewarp::test_in_threads
