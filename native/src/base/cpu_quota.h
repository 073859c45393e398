// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>

namespace wirewarp {

/// Returns the quota of cores of this process's control groups (cgroups, version 1 or 2), rounded up; nullopt without a
/// quota. Containers set such quotas. root: root folder of the file system, "/" except in tests.
std::optional<std::size_t> cpu_quota(const std::filesystem::path& root);

}  // namespace wirewarp
