// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <type_traits>

#include "base/factorization_failed.h"
#include "base/stop_token.h"

namespace wirewarp {

/// Returns the result of solve(), or an empty result if the caller stops it or a matrix has no factor in double
/// precision. StopToken::is_stopped() distinguishes the two cases.
template <typename Solve>
std::invoke_result_t<Solve> attempt(const Solve& solve) {
  try {
    return solve();
  } catch (const Stopped&) {
    return {};
  } catch (const FactorizationFailed&) {
    return {};
  }
}

template <typename Work>
bool was_stopped(const Work& work) {
  try {
    work();
  } catch (const Stopped&) {
    return true;
  }
  return false;
}

}  // namespace wirewarp
