// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>

namespace wirewarp {

/// Returns the number of cores that the control groups (cgroups, version 1 or 2) of this process allow at a time,
/// rounded up; nullopt without a quota. A container's limit is such a quota: the process may run on every core, but
/// pauses when its share of time is used up. root: root folder of the file system, "/" except in tests.
std::optional<std::size_t> cpu_quota(const std::filesystem::path& root);

}  // namespace wirewarp
