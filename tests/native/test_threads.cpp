// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that charts that are solved on several cores at once have the results of charts that are solved alone. Progress
// must be reported in the caller's thread.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>
#include <thread>

#include "base/cpu_quota.h"
#include "base/in_threads.h"
#include "base/progress_report.h"
#include "test_meshes.h"

namespace wirewarp::test_threads {
namespace {

FlattenInput many_gores() { return test::sphere_of_gores(12, 4, 16); }

/// Returns the faces of one piece as an input, with the vertices of the whole input.
FlattenInput only(const FlattenInput& input, const Piece& piece) {
  FlattenInput result = input;
  result.faces.resize(static_cast<Eigen::Index>(piece.source_face.size()), 3);
  for (std::size_t f = 0; f < piece.source_face.size(); ++f) {
    result.faces.row(static_cast<Eigen::Index>(f)) = input.faces.row(piece.source_face[f]);
  }
  result.seams.resize(0, 2);  // the seams are now the outline
  return result;
}

TEST(ChartsAtOnce, EachIsSolvedAsIfAlone) {
  const FlattenInput input = many_gores();
  const FlattenResult all = flatten(input);
  ASSERT_EQ(all.pieces.size(), 12U);
  for (const Piece& piece : all.pieces) {
    const FlattenResult alone = flatten(only(input, piece));
    ASSERT_EQ(alone.pieces.size(), 1U);
    EXPECT_EQ(alone.pieces[0].report.objective, piece.report.objective);  // bit for bit
    EXPECT_EQ(alone.pieces[0].report.factorizations, piece.report.factorizations);
  }
}

/// Flattens the input. Expects progress that never decreases, from 0 to 1, in the caller's thread only.
FlattenResult expect_progress(const FlattenInput& input, Method method) {
  Options options;
  options.method = method;
  const std::thread::id caller = std::this_thread::get_id();
  std::vector<double> fractions;
  bool elsewhere = false;
  FlattenResult result = flatten(input, options, [&](const std::string&, double fraction) {
    elsewhere = elsewhere || std::this_thread::get_id() != caller;
    fractions.push_back(fraction);
    return true;
  });
  EXPECT_FALSE(elsewhere);
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_EQ(fractions.front(), 0);
  EXPECT_EQ(fractions.back(), 1);
  return result;
}

TEST(ChartsAtOnce, ProgressIsReportedInTheCallersThreadAndNeverFalls) {
  const int n = 4;
  FlattenInput infeasible = test::quarter_sphere(n);  // a net of rigid wires
  infeasible.wires.clear();
  for (int i = 1; i < n; ++i) test::add_wire(infeasible, test::grid_column(n, 2 * n, i));
  for (int j = 1; j < 2 * n; ++j) test::add_wire(infeasible, test::grid_row(n, j));
  for (const Method method : {Method::refined, Method::wirewarp_plus_plus}) {
    expect_progress(many_gores(), method);
    const FlattenResult refused = expect_progress(infeasible, method);
    ASSERT_TRUE(refused.pieces.at(0).error);
    EXPECT_EQ(refused.pieces[0].error->code, ErrorCode::infeasible_lengths);
  }
}

TEST(ChartsAtOnce, CancelingReachesAllThreads) {
  int calls = 0;
  const FlattenResult result = flatten(many_gores(), {}, [&](const std::string&, double) { return ++calls < 2; });
  EXPECT_EQ(calls, 2);
  const auto is_cancelled = [](const Piece& piece) { return piece.error && piece.error->code == ErrorCode::cancelled; };
  // Each thread may have started one chart, and charts that are already flat are kept.
  const auto begun = static_cast<std::ptrdiff_t>(num_cores());
  EXPECT_GE(std::count_if(result.pieces.begin(), result.pieces.end(), is_cancelled), 12 - begun);
  for (const Piece& piece : result.pieces) {
    EXPECT_TRUE(!piece.error || is_cancelled(piece)) << piece.error->what();
  }
}

TEST(ChartsAtOnce, ExceptionsOfTheCallbackEndTheRun) {
  int calls = 0;
  const auto throwing = [&](const std::string&, double) -> bool {
    if (++calls < 3) return true;
    throw std::runtime_error("no more");
  };
  EXPECT_THROW(flatten(many_gores(), {}, throwing), std::runtime_error);
  EXPECT_EQ(calls, 3);
}

TEST(RunInThreads, RunsEachTaskOnce) {
  std::vector<std::atomic<int>> times(1000);
  run_in_threads(times.size(), 8, [&](std::size_t i) { ++times[i]; });
  for (const std::atomic<int>& count : times) EXPECT_EQ(count, 1);
  run_in_threads(0, 8, [](std::size_t) { FAIL(); });
}

TEST(InThreads, StartsNothingAfterAnException) {
  for (const std::size_t failing : {0, 1}) {  // in the calling thread, and in another thread
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
        // Waits, so that the exception arrives before all work is done.
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
        ++done;
      });
    } catch (const std::runtime_error& error) {
      thrown = error.what();
    }
    EXPECT_EQ(thrown, "work " + std::to_string(failing));
    EXPECT_LT(done, 999);
  }
}

TEST(ProgressReport, StaysCanceledIfTheCallerContinues) {
  ProgressReport* report = nullptr;
  const Progress progress = [&](const std::string&, double) {
    report->cancel();  // as another thread may do while the caller's function runs
    return true;
  };
  ProgressReport cancelled(progress);
  report = &cancelled;
  EXPECT_FALSE(cancelled.go_on("shape", 0));
  EXPECT_TRUE(cancelled.is_cancelled());
}

using Files = std::map<std::string, std::string>;  // contents of files, by path

/// Returns the quota, as a number of cores, on a system with these files.
std::optional<std::size_t> quota_with(const Files& files) {
  // Tests run in parallel, so each test needs its own folder.
  const std::filesystem::path root =
      testing::TempDir() + "cpu_quota_" + testing::UnitTest::GetInstance()->current_test_info()->name();
  std::filesystem::remove_all(root);
  for (const auto& [path, text] : files) {
    std::filesystem::create_directories((root / path).parent_path());
    std::ofstream(root / path) << text;
  }
  const std::optional<std::size_t> quota = cpu_quota(root);
  std::filesystem::remove_all(root);
  return quota;
}

const std::string kGroups = "proc/self/cgroup", kTree = "sys/fs/cgroup/";

TEST(CpuQuota, NoQuotaWithoutGroupsOrLimits) {
  EXPECT_FALSE(quota_with({}));
  EXPECT_FALSE(quota_with({{kGroups, "0::/\n"}}));
  EXPECT_FALSE(quota_with({{kGroups, "0::/a\n"}, {kTree + "a/cpu.max", "max 100000\n"}}));
  EXPECT_FALSE(quota_with({{kGroups, "0::/a\n"}, {kTree + "a/cpu.max", "no number\n"}}));
}

TEST(CpuQuota, VersionTwoInAContainer) {
  // In its own namespace, the container's group is the root of the tree.
  EXPECT_EQ(quota_with({{kGroups, "0::/\n"}, {kTree + "cpu.max", "200000 100000\n"}}), 2U);
  EXPECT_EQ(quota_with({{kGroups, "0::/\n"}, {kTree + "cpu.max", "150000 100000\n"}}), 2U);  // rounded up
  EXPECT_EQ(quota_with({{kGroups, "0::/\n"}, {kTree + "cpu.max", "10000 100000\n"}}), 1U);
  // The file names the group by its path on the host, but the mounted tree begins at the container's group.
  EXPECT_EQ(quota_with({{kGroups, "0::/docker/1a\n"}, {kTree + "cpu.max", "300000 100000\n"}}), 3U);
}

TEST(CpuQuota, UsesTheLeastOfAllParentGroups) {
  const Files files{{kGroups, "0::/user.slice/a/b\n"},
                    {kTree + "user.slice/cpu.max", "400000 100000\n"},
                    {kTree + "user.slice/a/cpu.max", "250000 50000\n"},
                    {kTree + "user.slice/a/b/cpu.max", "max 100000\n"},
                    {kTree + "other/cpu.max", "100000 100000\n"}};
  EXPECT_EQ(quota_with(files), 4U);
}

TEST(CpuQuota, VersionOneBesideOtherControllers) {
  const std::string group = kTree + "cpu/docker/1a/";
  const std::string groups = "7:cpuset:/docker/1a\n4:cpu,cpuacct:/docker/1a\n1:name=systemd:/docker/1a\n";
  EXPECT_EQ(
      quota_with(
          {{kGroups, groups}, {group + "cpu.cfs_quota_us", "200000\n"}, {group + "cpu.cfs_period_us", "100000\n"}}),
      2U);
  EXPECT_FALSE(
      quota_with({{kGroups, groups}, {group + "cpu.cfs_quota_us", "-1\n"}, {group + "cpu.cfs_period_us", "100000\n"}}));
}

}  // namespace
}  // namespace wirewarp::test_threads
