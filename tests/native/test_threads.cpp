// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that charts are solved on several cores at once, and that the caller is asked whether to continue after every
// fixed amount of work.
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
#include "base/work_meter.h"
#include "error_of.h"
#include "result/pack_boxes.h"
#include "surface/mesh/overlap.h"
#include "test_meshes.h"
#include "warp/topology/process_topology.h"

namespace wirewarp::test_threads {
namespace {

FlattenInput many_gores() { return test::sphere_of_gores(12, 4, 16); }

/// Returns the faces of one piece as an input, with the vertices of the whole input.
FlattenInput only(const FlattenInput& input, const Piece& piece) {
  FlattenInput result = input;
  result.faces.resize(piece.source_face.size(), 3);
  for (std::size_t f = 0; f < piece.source_face.size(); ++f) {
    result.faces.row(f) = input.faces.row(piece.source_face[f]);
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

FlattenResult expect_progress(const FlattenInput& input, Method method) {
  Options options = test::by(method);
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
  const FlattenInput infeasible = test::saddle_of_wires(4, 0);
  for (const Method method : {Method::refined, Method::wirewarp_plus_plus}) {
    expect_progress(many_gores(), method);
    const FlattenResult refused = expect_progress(infeasible, method);
    test::expect_error(refused.pieces.at(0).error, ErrorCode::infeasible_lengths);
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
  Files files{{kGroups, groups}, {group + "cpu.cfs_quota_us", "200000\n"}, {group + "cpu.cfs_period_us", "100000\n"}};
  EXPECT_EQ(quota_with(files), 2U);
  files[group + "cpu.cfs_quota_us"] = "-1\n";
  EXPECT_FALSE(quota_with(files));
}

FlattenInput confetti(int n) {
  FlattenInput input = test::flat_rectangle(n, n, n, n);
  input.seams.resize(2 * n * (n + 1), 2);
  int row = 0;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i < n; ++i) {
      input.seams.row(row++) << i + (n + 1) * j, i + 1 + (n + 1) * j;
      input.seams.row(row++) << j + (n + 1) * i, j + (n + 1) * (i + 1);
    }
  }
  return input;
}

std::map<std::string, int> questions(const FlattenInput& input) {
  std::map<std::string, int> asked;
  flatten(input, {}, [&](const std::string& stage, double) {
    ++asked[stage];
    return true;
  });
  return asked;
}

/// Counts polls, and answers no from poll number `limit` on.
struct Asked {
  int times = 0;
  StopToken stop{[this](const char*) { return ++times < limit; }};
  int limit = 1'000'000;
};

TEST(Questions, AreAskedAtLeastInProportionToTheFaces) {
  const int few = 40, many = 110;
  const std::map<std::string, int> before = questions(confetti(few)), after = questions(confetti(many));
  const int faces = 2 * many * many;
  EXPECT_GE(after.at("charts"), faces / static_cast<int>(WorkMeter::work_per_question));
  EXPECT_GE(after.at("measure"), 2 * faces / static_cast<int>(WorkMeter::work_per_question));
  EXPECT_GE(after.at("start"), 1);
  EXPECT_GE(before.at("charts"), 1);
}

TEST(Questions, ARefusalEndsARunOfManyChartsInAnyStage) {
  const FlattenInput input = confetti(100);
  for (const std::string last : {"charts", "start", "measure"}) {
    int asked_after = 0;
    bool is_over = false;
    const FlattenResult result = flatten(input, {}, [&](const std::string& stage, double) {
      asked_after += is_over;
      is_over = is_over || stage == last;
      return !is_over;
    });
    EXPECT_EQ(asked_after, 0) << last;
    ASSERT_EQ(result.pieces.size(), 10'000U) << last;
    EXPECT_EQ(result.pieces.back().error.value().code, ErrorCode::cancelled) << last;
    EXPECT_EQ(result.pieces.back().source_vertex.size(), 4U) << last;
    EXPECT_EQ(result.pieces.back().report.termination, Termination::cancelled) << last;
  }
}

TEST(Questions, AreAskedAmongOverlapsOfACrumpledPiece) {
  const int n = 800;  // number of triangles, which all overlap: 320,000 pairs
  Triangles faces(n, 3);
  Positions2 uv(3 * n, 2);
  for (int f = 0; f < n; ++f) {
    faces.row(f) << 3 * f, 3 * f + 1, 3 * f + 2;
    uv.middleRows(3 * f, 3) << 0, 0, 1, 0, 0, 1 + 1e-3 * f;
  }
  Asked asked;
  find_overlapping_faces(faces, std::vector<bool>(n, true), uv, kRelativeOverlapDepth, asked.stop);
  EXPECT_GE(asked.times, n * (n / 2) / static_cast<int>(WorkMeter::work_per_question));
  Asked refused;
  refused.limit = 3;
  EXPECT_THROW(find_overlapping_faces(faces, std::vector<bool>(n, true), uv, kRelativeOverlapDepth, refused.stop),
               Stopped);
  EXPECT_EQ(refused.times, 3);
}

TEST(Questions, AreAskedWhileBoxesArePacked) {
  Positions2 sizes(3000, 2);
  for (int i = 0; i < sizes.rows(); ++i) sizes.row(i) << 1 + (i * 37) % 101, 1 + (i * 53) % 97;
  Asked asked;
  pack_boxes(sizes, 0.1, asked.stop);
  EXPECT_GE(asked.times, 16 * sizes.rows() / static_cast<int>(WorkMeter::work_per_question));
}

TEST(Questions, AreAskedWhileWiresAreExtended) {
  const int n = 41, num_wires = 30;
  FlattenInput input = test::flat_rectangle(n - 1, n - 1, 1, 1);
  // Each wire is one edge far from the other wires, so at least one of its ends is extended.
  for (int i = 0; i < num_wires; ++i) {
    const int v = 3 + 6 * (i % 6) + n * (3 + 7 * (i / 6));
    test::add_wire(input, {v, v + n});
  }
  const Chart chart = test::chart_of(input);
  Asked asked;
  EXPECT_TRUE(process_topology(chart, asked.stop));
  EXPECT_GE(asked.times, num_wires * n * n / static_cast<int>(WorkMeter::work_per_question));
  Asked refused;
  refused.limit = 2;
  EXPECT_THROW(process_topology(chart, refused.stop), Stopped);
  EXPECT_EQ(refused.times, 2);
}

TEST(Questions, TheLastStageOfASmallRunIsNotCanceled) {
  bool was_cancelled = false;
  const FlattenResult result = flatten(test::quarter_sphere(4), {}, [&](const std::string& stage, double) {
    was_cancelled = was_cancelled || stage == "measure";
    return stage != "measure";
  });
  EXPECT_TRUE(was_cancelled);
  EXPECT_FALSE(result.pieces[0].error.has_value());
  EXPECT_TRUE(result.corner_uv.allFinite());
}

}  // namespace
}  // namespace wirewarp::test_threads
