// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts a mesh along lines, then cuts the result along more lines. Both cuts together become one cut of the first mesh.
#pragma once

#include <vector>

#include "wirewarp/cut_mesh.h"
#include "wirewarp/flatten.h"

namespace wirewarp {

/// Returns a mesh without cuts, from which cut_again() starts. Its sources are only those of faces and corners.
CutMesh uncut(const FlattenInput& input);

/// Returns the mesh `before`, cut also along the paths that do not collapse (see not_collapsed()). The edges of the
/// result include earlier cuts. Its sources are only those of faces and corners, in the first, uncut mesh.
CutMesh cut_again(const CutMesh& before, const std::vector<SurfacePath>& paths);

/// Returns one flag per path: 0 if cut_mesh() refuses the path because all its points move to one point. Other paths
/// that end at such a path then meet in this point.
std::vector<char> not_collapsed(const Triangles& faces, int num_vertices, const std::vector<SurfacePath>& paths);

std::vector<SurfacePath> selected(const std::vector<SurfacePath>& paths, const std::vector<char>& flags);

}  // namespace wirewarp
