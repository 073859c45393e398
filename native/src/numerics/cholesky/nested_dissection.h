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

/// A tree whose nodes are disjoint sets of vertices. An edge of the graph connects vertices of one node, or of a node
/// and one of its ancestors.
struct DissectionTree {
  struct Node {
    std::vector<int> vertices;  // at least one
    int parent;                 // -1 at a root; a connected graph has one root
  };
  std::vector<Node> nodes;  // in postorder: descendants directly before their ancestor
};

/// Returns the tree of separators. positions: one finite row per vertex; the last vertices may have no row, and then
/// form the root above all other nodes. Poor positions only cause more nonzeros.
DissectionTree nested_dissection(const Graph& graph, const Positions2& positions);

}  // namespace wirewarp
