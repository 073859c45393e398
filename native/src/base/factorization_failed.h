// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>

namespace wirewarp {

/// A matrix that should have a factor has none in double precision. If a factorization is a test (is this Hessian
/// positive definite?), it returns a bool instead.
class FactorizationFailed : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace wirewarp
