// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace wirewarp {

/// Share of the predicted linear decrease that a step must achieve, in all line searches (Nocedal, Wright, Numerical
/// Optimization, section 3.1).
inline constexpr double kSufficientDecrease = 1e-4;

}  // namespace wirewarp
