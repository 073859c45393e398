// SPDX-License-Identifier: GPL-3.0-or-later
// Divides the triangles of a mesh so that lines across them become edges.
#pragma once

#include <vector>

#include "wirewarp/surface_path.h"

namespace wirewarp {

using CornerWeights = Eigen::Matrix<double, Eigen::Dynamic, 9, Eigen::RowMajor>;  // m by (3 corners x 3 weights)

/// The input elements from which each element of a cut mesh was made. Use them to transfer attributes of any kind.
struct CutSources {
  Triangles vertices;            // (n, 3) input vertices from which each vertex is interpolated
  Positions3 vertex_weights;     // (n, 3) weights of the vertices in each row of `vertices`; they sum to 1
  std::vector<int> faces;        // (m,) input face that contains each face
  CornerWeights corner_weights;  // (m, 3, 3) for each corner of a face, the weights of the input face's corners
  std::vector<int> edge_paths;   // (k,) index of the path to which each edge belongs
  std::vector<std::vector<int>> divided_edges;  // vertices along each divided edge of the input, including its ends
};

struct CutMesh {
  Positions3 vertices;  // (n, 3) vertices of the input, then the new vertices
  Triangles faces;      // (m, 3) each input face or one part of it, in the input's order; then all other parts
  std::vector<VertexPair> edges;  // (k, 2) edges of the paths in order, one path after the other, each edge once
  CutSources sources;
};

/// Divides triangles so that paths become edges. The surface does not change.
///
/// - New vertices are on edges or in triangles of the input. Vertices keep their numbers.
/// - Faces keep their orientation, and a manifold mesh remains a manifold.
/// - Paths may cross, touch or follow each other, and may follow edges. A crossing becomes a vertex.
///
/// To avoid slivers, points move in three cases:
///
/// - to an edge, if the barycentric coordinate of the opposite corner is less than snap
/// - from an edge to its end, if the weight of the other end is less than snap
/// - to another point, if all their coordinates differ by less than snap
///
/// A line that passes a point within half of snap leads through this point. A snapped line does not move if it is cut
/// into the mesh again.
///
/// snap is from 0.0001 to 0.25. With snap 0.05 and edges of 10 mm, a line moves by 1 mm at most. If one straight line
/// crosses a triangle, its parts are at least snap (1 - snap) times as high as the triangle. Lines that meet at small
/// angles leave smaller parts.
///
/// Throws:
///
/// - empty_mesh, vertex_out_of_range, non_finite_coordinates or repeated_vertex_in_face for a faulty mesh
/// - invalid_option if snap is out of its range, or if a path is not on the mesh
/// - invalid_option if consecutive points of a path have no common triangle, or if all its points snap together
CutMesh cut_mesh(const Positions3& vertices, const Triangles& faces, const std::vector<SurfacePath>& paths,
                 double snap = 0.05);

}  // namespace wirewarp
