// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>

namespace wirewarp {

/// A matrix that has a factor has none in double precision. Where a factorization is a question (is this Hessian
/// positive definite?), its answer is a bool instead.
class FactorizationFailed : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace wirewarp
