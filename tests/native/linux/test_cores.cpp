// SPDX-License-Identifier: GPL-3.0-or-later
// As many threads as there are cores to use, and no more than the system gives.
#include <gtest/gtest.h>
#include <sched.h>

#include <algorithm>

#include "cpu_quota.h"
#include "in_threads.h"
#include "refuse_threads.h"
#include "test_meshes.h"

namespace wirewarp {
namespace {

TEST(Cores, AreThoseThatTheThreadMayUse) {
  cpu_set_t before;
  ASSERT_EQ(sched_getaffinity(0, sizeof before, &before), 0);
  const auto count = static_cast<std::size_t>(CPU_COUNT(&before));
  EXPECT_EQ(num_cores(), std::min(count, cpu_quota("/").value_or(count)));
  cpu_set_t one;
  CPU_ZERO(&one);
  for (int cpu = 0; CPU_COUNT(&one) == 0; ++cpu) {
    if (CPU_ISSET(cpu, &before)) CPU_SET(cpu, &one);
  }
  ASSERT_EQ(sched_setaffinity(0, sizeof one, &one), 0);
  EXPECT_EQ(num_cores(), 1U);
  EXPECT_FALSE(has_second_core());
  ASSERT_EQ(sched_setaffinity(0, sizeof before, &before), 0);
}

TEST(Cores, TheThreadsThereAreDoAll) {
  for (const FlattenInput& input : {test::sphere_of_gores(12, 4, 16), test::quarter_sphere(40)}) {
    const FlattenResult expected = flatten(input);
    const test::RefuseThreads refuse;
    const FlattenResult result = flatten(input);
    EXPECT_EQ(result.corner_uv, expected.corner_uv);  // bit for bit
    for (const Piece& piece : result.pieces) EXPECT_FALSE(piece.error) << piece.error->what();
    EXPECT_TRUE(num_cores() == 1 || refuse.num_refused() > 0);
  }
}

TEST(Cores, ChartsThatKeepAllCoresBusyStartNoThreadsOfTheirOwn) {
  const std::size_t num_charts = 12;
  const FlattenInput input = test::sphere_of_gores(12, 4, 16);
  const test::RefuseThreads refuse;
  flatten(input);
  EXPECT_TRUE(num_cores() > num_charts || refuse.num_refused() <= 1);  // once none is given, no chart asks for another
}

}  // namespace
}  // namespace wirewarp
