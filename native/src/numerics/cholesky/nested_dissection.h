// SPDX-License-Identifier: GPL-3.0-or-later
// The elimination order: a tree of separators of a graph with positions in the plane (A. George, Nested dissection of a
// regular finite element mesh, SIAM J. Numer. Anal. 10, 1973).
#pragma once

#include <vector>

#include "wirewarp/types.h"

namespace wirewarp {

/// An undirected graph without loops. The neighbors of vertex v are neighbors[start[v]] to neighbors[start[v + 1] - 1],
/// so start has one entry more than there are vertices. Every edge is listed at both ends.
struct Graph {
  std::vector<int> start;
  std::vector<int> neighbors;

  int num_vertices() const { return static_cast<int>(start.size()) - 1; }
};

/// A tree of sets of vertices. Each vertex belongs to one node. An edge of the graph connects two vertices of one node,
/// or a vertex of a node with a vertex of an ancestor of this node.
struct DissectionTree {
  struct Node {
    std::vector<int> vertices;  // at least one
    int parent;                 // -1 at a root; a connected graph has one root
  };
  std::vector<Node> nodes;  // in postorder: descendants directly before their ancestor
};

/// Returns the tree of separators. Bisects each connected part recursively at the median of a coordinate, in the best
/// of four directions, down to leaves of at most 16 vertices. A separator is the smallest set of vertices that contains
/// an end of every edge between the halves. positions: one finite row for each vertex, except that the last vertices
/// may have no row. These last vertices form the root above all other nodes. Poor positions (for example, all equal)
/// cause more nonzeros in the factor, not errors.
DissectionTree nested_dissection(const Graph& graph, const Positions2& positions);

}  // namespace wirewarp
