// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>

namespace wirewarp {

/// Thrown if rounding errors leave no path for a helper wire that Eq. (1) needs between the wires and outlines of a
/// chart (paper III).
class UnjoinedWires : public std::domain_error {
 public:
  using std::domain_error::domain_error;
};

}  // namespace wirewarp
