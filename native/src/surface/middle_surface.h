// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wirewarp/flatten.h"

namespace wirewarp {

/// Returns the input with its vertices moved along their normals to the middle of the material (Options::thickness,
/// Options::surface). Throws FlattenError (invalid_option) if this flips triangles.
FlattenInput move_to_middle(const FlattenInput& input, const Options& options);

}  // namespace wirewarp
