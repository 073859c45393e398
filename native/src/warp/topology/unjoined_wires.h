// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>

namespace wirewarp {

/// Thrown if the wires and outlines of a chart cannot be joined to a network that Eq. (1) can solve (paper III), for
/// example because rounding errors leave no path for a helper wire.
class UnjoinedWires : public std::domain_error {
 public:
  using std::domain_error::domain_error;
};

}  // namespace wirewarp
