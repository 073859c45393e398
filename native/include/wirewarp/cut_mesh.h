// SPDX-License-Identifier: GPL-3.0-or-later
// Makes edges of lines that cross the triangles of a mesh.
#pragma once

#include <vector>

#include "wirewarp/surface_path.h"

namespace wirewarp {

using CornerWeights = Eigen::Matrix<double, Eigen::Dynamic, 9, Eigen::RowMajor>;  // m by (3 corners x 3 shares)

/// What the elements of a cut mesh are made of, so that attributes of any kind can be taken over.
struct CutSources {
  Triangles vertices;            // (n, 3) vertices of the input from which each vertex is mixed
  Positions3 vertex_weights;     // (n, 3) their shares, with the sum 1
  std::vector<int> faces;        // (m,) face of the input in which each face lies
  CornerWeights corner_weights;  // (m, 3, 3) for each corner of a face, the shares of the corners of that input face
  std::vector<int> edge_paths;   // (k,) the path to which each of the edges belongs
  std::vector<std::vector<int>> divided_edges;  // vertices along each edge of the input that was divided, ends included
};

struct CutMesh {
  Positions3 vertices;            // (n, 3) those of the input, then the new ones
  Triangles faces;                // (m, 3) faces that no path crosses keep their place; parts of the others come last
  std::vector<VertexPair> edges;  // (k, 2) of the paths in order, one path after the other, each edge once
  CutSources sources;
};

/// Divides triangles so that paths become edges. The surface stays as it is: each new vertex lies on an edge or in a
/// triangle of the input, and vertices keep their numbers. Faces keep their orientation, and a manifold stays one.
/// Paths may cross, touch and follow each other and edges; where they cross there is a vertex.
///
/// So that no slivers arise, points move where they are nearer to something than `snap`: to an edge if the barycentric
/// coordinate of its opposite corner is less, to a vertex if the share of the other end of their edge is less, and to
/// another point whose coordinates all differ by less. A line that passes a site within half of that leads through it.
/// snap is from 0.0001 to 0.25. With 0.05, where edges are 10 mm long, a line moves by 1 mm at most. The parts of a
/// triangle that a straight line crosses are at least snap (1 - snap) times as high, and the line does not move if it
/// is cut again. Lines that meet at small angles leave smaller parts.
///
/// Throws empty_mesh, vertex_out_of_range, non_finite_coordinates, repeated_vertex_in_face, and invalid_option for a
/// path that is not on the mesh, has two points in a row in no common triangle, or is all within reach of one point.
CutMesh cut_mesh(const Positions3& vertices, const Triangles& faces, const std::vector<SurfacePath>& paths,
                 double snap = 0.05);

}  // namespace wirewarp
