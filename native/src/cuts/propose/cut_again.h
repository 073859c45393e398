// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts a mesh along lines, then cuts the result along more lines. Both cuts together become one cut of the first mesh.
#pragma once

#include <vector>

#include "wirewarp/cut_mesh.h"
#include "wirewarp/flatten.h"

namespace wirewarp {

/// Returns the input's mesh as a cut mesh without any cut.
CutMesh uncut(const FlattenInput& input);

/// Returns a cut mesh with more cuts along paths on it. Paths that collapse are left out. The edges include the edges
/// of earlier cuts. The sources of faces and corners are in the first mesh. The sources of vertices and the divided
/// edges are in the mesh `before`. Do not use CutSources::edge_paths: it does not list all edges.
CutMesh cut_again(const CutMesh& before, const std::vector<SurfacePath>& paths);

/// Returns one flag per path: 0 if cut_mesh() refuses the path because all its points move to one point. Other paths
/// that end at such a path then meet in this point.
std::vector<char> not_collapsed(const Triangles& faces, int num_vertices, const std::vector<SurfacePath>& paths);

/// Returns the paths whose flag is not 0.
std::vector<SurfacePath> selected(const std::vector<SurfacePath>& paths, const std::vector<char>& flags);

}  // namespace wirewarp
