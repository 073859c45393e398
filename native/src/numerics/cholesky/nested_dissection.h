// SPDX-License-Identifier: GPL-3.0-or-later
// The order of elimination: a tree of separators of a graph that is drawn in the plane (A. George, Nested dissection of
// a regular finite element mesh, SIAM J. Numer. Anal. 10, 1973).
#pragma once

#include <vector>

#include "wirewarp/types.h"

namespace wirewarp {

/// An undirected graph without loops: the neighbors of vertex v are neighbors[start[v]] to neighbors[start[v + 1] - 1].
/// start has one entry more than there are vertices. Every edge stands with both of its ends.
struct Graph {
  std::vector<int> start;
  std::vector<int> neighbors;

  int num_vertices() const { return static_cast<int>(start.size()) - 1; }
};

/// Each vertex belongs to one node. An edge of the graph joins vertices of one node, or of a node and an ancestor of
/// it.
struct DissectionTree {
  struct Node {
    std::vector<int> vertices;  // at least one
    int parent;                 // -1 at a root; a connected graph has one root
  };
  std::vector<Node> nodes;  // in postorder: descendants right before their ancestor
};

/// Halves the vertices again and again by the median of a coordinate, in the best of four directions, down to leaves
/// of at most 16, each connected part by itself. A separator is as few vertices as meet all edges between the halves.
/// positions: one finite row per vertex. Positions that say little (all alike, say) cost fill, not correctness.
/// Vertices beyond the last row are the root of all others.
DissectionTree nested_dissection(const Graph& graph, const Positions2& positions);

}  // namespace wirewarp
