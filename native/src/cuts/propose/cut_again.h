// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts a mesh along lines, then the result along more lines, as one cut of the first mesh.
#pragma once

#include <map>
#include <vector>

#include "wirewarp/cut_mesh.h"
#include "wirewarp/flatten.h"

namespace wirewarp {

/// Returns a mesh without cuts.
CutMesh uncut(const FlattenInput& input);

/// Cuts a cut mesh along more paths on it, without those that collapse. The edges are those of all cuts. The sources,
/// of vertices and faces only, are in the first mesh.
CutMesh cut_again(const CutMesh& before, std::vector<SurfacePath> paths);

/// Returns the weights of the vertices of the first mesh in a vertex of the cut mesh. Weights of 0 are left out.
std::map<int, double> weights_of(const CutSources& sources, int vertex);

/// Returns the paths without those whose points cut_mesh() moves to one point, because it refuses such paths. Other
/// paths that end there then meet in that point.
std::vector<SurfacePath> without_collapsed(const Triangles& faces, int num_vertices, std::vector<SurfacePath> paths);

}  // namespace wirewarp
