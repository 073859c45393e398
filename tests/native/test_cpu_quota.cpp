// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include "base/cpu_quota.h"

namespace wirewarp::test_cpu_quota {
namespace {

using Files = std::map<std::string, std::string>;  // text by path

/// The quota of a system with these files.
std::optional<std::size_t> quota_with(const Files& files) {
  const std::filesystem::path root = testing::TempDir() + "cpu_quota";
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
  // In a name space of its own the container's group is the root of its tree.
  EXPECT_EQ(quota_with({{kGroups, "0::/\n"}, {kTree + "cpu.max", "200000 100000\n"}}), 2U);
  EXPECT_EQ(quota_with({{kGroups, "0::/\n"}, {kTree + "cpu.max", "150000 100000\n"}}), 2U);  // rounded up
  EXPECT_EQ(quota_with({{kGroups, "0::/\n"}, {kTree + "cpu.max", "10000 100000\n"}}), 1U);
  // The group has the path of the host, but the tree begins at the container's.
  EXPECT_EQ(quota_with({{kGroups, "0::/docker/1a\n"}, {kTree + "cpu.max", "300000 100000\n"}}), 3U);
}

TEST(CpuQuota, TheLeastOfAllGroupsAbove) {
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
}  // namespace wirewarp::test_cpu_quota
