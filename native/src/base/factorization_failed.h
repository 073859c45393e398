// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>

namespace wirewarp {

/// Thrown if a matrix that should have a factor has none in double precision. A factorization that tests whether a
/// matrix is positive definite returns a bool instead.
class FactorizationFailed : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace wirewarp
