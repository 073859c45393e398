// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that a run uses one thread for each core that it may use, and works with fewer threads if the system refuses
// more.
#include <dlfcn.h>
#include <gtest/gtest.h>
#include <pthread.h>
#include <sched.h>

#include <algorithm>
#include <atomic>
#include <cerrno>

#include "base/cpu_quota.h"
#include "base/in_threads.h"
#include "test_meshes.h"

namespace wirewarp::test_cores {
namespace {

std::atomic<bool> refuses_threads{false};
std::atomic<int> num_refused_threads{0};

}  // namespace
}  // namespace wirewarp::test_cores

/// Replaces the system's pthread_create for every library that this program loads.
extern "C" __attribute__((visibility("default"))) int create_or_refuse(pthread_t* thread,
                                                                       const pthread_attr_t* attributes,
                                                                       void* (*work)(void*), void* argument) noexcept
    __asm__("pthread_create");

int create_or_refuse(pthread_t* thread, const pthread_attr_t* attributes, void* (*work)(void*),
                     void* argument) noexcept {
  if (wirewarp::test_cores::refuses_threads) {
    ++wirewarp::test_cores::num_refused_threads;
    return EAGAIN;
  }
  static const auto create = reinterpret_cast<decltype(&pthread_create)>(dlsym(RTLD_NEXT, "pthread_create"));
  return create(thread, attributes, work, argument);
}

namespace wirewarp::test_cores {
namespace {

class RefuseThreads {
 public:
  RefuseThreads() {
    num_refused_threads = 0;
    refuses_threads = true;
  }
  ~RefuseThreads() { refuses_threads = false; }
  RefuseThreads(const RefuseThreads&) = delete;
  RefuseThreads& operator=(const RefuseThreads&) = delete;
};

/// While an object of this class exists, this thread may use only the first `count` of its cores.
class FirstCores {
 public:
  explicit FirstCores(int count) {
    EXPECT_EQ(sched_getaffinity(0, sizeof before_, &before_), 0);
    cpu_set_t first;
    CPU_ZERO(&first);
    for (int cpu = 0; cpu < CPU_SETSIZE && CPU_COUNT(&first) < count; ++cpu) {
      if (CPU_ISSET(cpu, &before_)) CPU_SET(cpu, &first);
    }
    EXPECT_EQ(sched_setaffinity(0, sizeof first, &first), 0);
  }
  ~FirstCores() { EXPECT_EQ(sched_setaffinity(0, sizeof before_, &before_), 0); }
  FirstCores(const FirstCores&) = delete;
  FirstCores& operator=(const FirstCores&) = delete;

 private:
  cpu_set_t before_;
};

TEST(Cores, AreThoseThatTheThreadMayUse) {
  cpu_set_t all;
  ASSERT_EQ(sched_getaffinity(0, sizeof all, &all), 0);
  const auto count = static_cast<std::size_t>(CPU_COUNT(&all));
  EXPECT_EQ(num_cores(), std::min(count, cpu_quota("/").value_or(count)));
  const FirstCores one(1);
  EXPECT_EQ(num_cores(), 1U);
  EXPECT_FALSE(has_second_core());
}

TEST(Cores, IfTheSystemRefusesThreadsTheCallingThreadDoesTheWork) {
  for (const FlattenInput& input : {test::sphere_of_gores(12, 4, 16), test::quarter_sphere(40)}) {
    const FlattenResult expected = flatten(input);
    const RefuseThreads refuse;
    const FlattenResult result = flatten(input);
    EXPECT_EQ(result.corner_uv, expected.corner_uv);  // bit for bit
    for (const Piece& piece : result.pieces) EXPECT_FALSE(piece.error) << piece.error->what();
    EXPECT_EQ(num_refused_threads > 0, num_cores() > 1);
  }
}

TEST(Cores, ChartsThatKeepAllCoresBusyStartNoThreadsOfTheirOwn) {
  const FirstCores two(2);  // fewer cores than charts
  if (num_cores() < 2) GTEST_SKIP() << "one core starts no threads at all";
  const FlattenInput input = test::sphere_of_gores(12, 4, 16);
  const RefuseThreads refuse;
  flatten(input);
  EXPECT_EQ(num_refused_threads, 1);  // the run starts one thread, which all charts share
}

}  // namespace
}  // namespace wirewarp::test_cores
