// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/cpu_quota.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <sstream>
#include <string>

namespace wirewarp {
namespace {

using Folder = std::filesystem::path;
using Cores = std::optional<std::size_t>;

std::string text_of(const Folder& file) {
  // C functions read the file, because libstdc++'s file streams need a newer glibc than the wheels need.
  std::string text;
  if (std::FILE* const stream = std::fopen(file.string().c_str(), "r")) {
    std::array<char, 4096> part{};  // one page of memory; most of these files are shorter
    while (const std::size_t count = std::fread(part.data(), 1, part.size(), stream)) text.append(part.data(), count);
    std::fclose(stream);
  }
  return text;
}

/// Returns a quota in cores, rounded up; nullopt without a quota. text: microseconds of work allowed in a period, then
/// microseconds of the period. "max" (version 2) and -1 (version 1) mean no quota.
Cores cores_of(const std::string& text) {
  double work = 0, period = 0;
  if (!(std::istringstream(text) >> work >> period) || !(work > 0 && period > 0)) return std::nullopt;
  return static_cast<std::size_t>(std::ceil(work / period));
}

Cores fewer(Cores a, Cores b) { return a && b ? std::min(a, b) : a ? a : b; }

Cores quota_of_group(const Folder& group) {
  return fewer(cores_of(text_of(group / "cpu.max")),
               cores_of(text_of(group / "cpu.cfs_quota_us") + " " + text_of(group / "cpu.cfs_period_us")));
}

/// Returns the smallest quota of a group and of the groups above it, up to the mounted folder. In a container, this
/// folder may be the group itself, without the group's path below it.
Cores quota_in_tree(const Folder& mount, Folder group) {
  Cores least = quota_of_group(mount);
  for (; group.has_relative_path(); group = group.parent_path()) {
    least = fewer(least, quota_of_group(mount / group.relative_path()));
  }
  return least;
}

}  // namespace

Cores cpu_quota(const Folder& root) {
  const Folder mount = root / "sys/fs/cgroup";
  Cores least;
  std::istringstream groups(text_of(root / "proc/self/cgroup"));
  // Lines are, for example, "0::/user.slice" (version 2) or "4:cpu,cpuacct:/docker/1a" (version 1).
  for (std::string line; std::getline(groups, line);) {
    const std::size_t first = line.find(':'), second = line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string controllers = "," + line.substr(first + 1, second - first - 1) + ",";
    const Folder group = line.substr(second + 1);
    if (controllers == ",,") least = fewer(least, quota_in_tree(mount, group));
    if (controllers.find(",cpu,") != std::string::npos) least = fewer(least, quota_in_tree(mount / "cpu", group));
  }
  return least;
}

}  // namespace wirewarp
