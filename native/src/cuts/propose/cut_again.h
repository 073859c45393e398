// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts a mesh along lines, then the result along more lines, as one cut of the first mesh.
#pragma once

#include <vector>

#include "wirewarp/cut_mesh.h"
#include "wirewarp/flatten.h"

namespace wirewarp {

/// Returns a mesh without cuts.
CutMesh uncut(const FlattenInput& input);

/// Cuts a cut mesh along more paths on it, without those that collapse. The edges are those of all cuts. The sources
/// of faces and corners are in the first mesh; the other sources are in the mesh before.
CutMesh cut_again(const CutMesh& before, const std::vector<SurfacePath>& paths);

/// Returns one flag per path: 0 if cut_mesh() moves all its points to one point, because it refuses such paths. Other
/// paths that end there then meet in that point.
std::vector<char> not_collapsed(const Triangles& faces, int num_vertices, const std::vector<SurfacePath>& paths);

/// Returns the paths whose flag is not 0.
std::vector<SurfacePath> selected(const std::vector<SurfacePath>& paths, const std::vector<char>& flags);

}  // namespace wirewarp
