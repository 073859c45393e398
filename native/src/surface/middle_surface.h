// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wirewarp/flatten.h"

namespace wirewarp {

/// Returns the input with its vertices moved to the middle of the material (Options::thickness, Options::surface). Each
/// vertex moves along the mean of the normals around it, weighted by angles (G. Thürmer, C. Wüthrich, Computing vertex
/// normals from polygonal facets, 1998). A vertex on a seam moves equally in all its pieces. Throws FlattenError
/// (invalid_option) if this flips triangles, because the surface is curved too tightly for the thickness.
FlattenInput move_to_middle(const FlattenInput& input, const Options& options);

}  // namespace wirewarp
