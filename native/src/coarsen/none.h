// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace wirewarp {

/// In place of an index: there is none.
constexpr int kNone = -1;

}  // namespace wirewarp
