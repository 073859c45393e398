// SPDX-License-Identifier: GPL-3.0-or-later
// The undirected edges of a triangle list, with the sides of faces at each edge. An edge may have any number of sides,
// because seams may be non-manifold. Side 3 f + k of face f runs from its corner k to corner k + 1.
#pragma once

#include <vector>

#include "wirewarp/types.h"

namespace wirewarp {

class EdgeTable {
 public:
  /// faces: vertex indices in [0, num_vertices).
  EdgeTable(const Triangles& faces, int num_vertices);

  int num_edges() const { return static_cast<int>(vertices_.size()); }
  int num_sides(int edge) const { return side_begin_[edge + 1] - side_begin_[edge]; }

  /// Returns the j-th side of an edge, by ascending face.
  int side(int edge, int j) const { return sides_[side_begin_[edge] + j]; }
  int edge_of_side(int side) const { return edge_of_side_[side]; }

  /// Returns the two ends of an edge, the smaller index first.
  const VertexPair& vertices(int edge) const { return vertices_[edge]; }

  /// Returns the edge between two vertices; -1 if there is none.
  int find(int a, int b) const;

  /// Returns the vertex at which a side starts (from) or ends (to).
  int from(int side) const { return faces_(side / 3, side % 3); }
  int to(int side) const { return faces_(side / 3, (side + 1) % 3); }

  /// Returns the corner 3 f + k of a side's face at one of the side's ends.
  int corner_at(int side, int vertex) const { return from(side) == vertex ? side : side - side % 3 + (side + 1) % 3; }

 private:
  const Triangles& faces_;
  std::vector<VertexPair> vertices_;
  std::vector<int> edge_begin_;  // per vertex: the first edge whose smaller end is this vertex
  std::vector<int> side_begin_;
  std::vector<int> sides_;
  std::vector<int> edge_of_side_;
};

}  // namespace wirewarp
