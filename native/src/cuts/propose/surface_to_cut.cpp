// SPDX-License-Identifier: GPL-3.0-or-later
#include "cuts/propose/surface_to_cut.h"

#include "flatten.h"
#include "surface/middle_surface.h"

namespace wirewarp {

SurfaceToCut::SurfaceToCut(const FlattenInput& input, const Options& options) : input_(input) {
  check_request(input, options);
  if (options.thickness > 0) middle_ = move_to_middle(input, options);
}

}  // namespace wirewarp
