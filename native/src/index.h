// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace wirewarp {

/// Meshes and matrices count in int, std::vector in std::size_t.
inline std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace wirewarp
