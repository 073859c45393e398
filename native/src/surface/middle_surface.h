// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wirewarp/flatten.h"

namespace wirewarp {

/// The same with its vertices in the middle of the material (Options::thickness, Options::surface): each has moved
/// along the mean of the normals around it, weighted by their angles (G. Thürmer, C. Wüthrich, Computing vertex normals
/// from polygonal facets, 1998), the same way for all pieces that meet in it. Throws FlattenError (invalid_option)
/// where that turns triangles over: there the surface is curved more tightly than the material is thick.
FlattenInput move_to_middle(const FlattenInput& input, const Options& options);

}  // namespace wirewarp
