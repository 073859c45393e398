// SPDX-License-Identifier: GPL-3.0-or-later
// Sites: the vertices, points on edges and points in faces through which paths on a mesh pass. Sites are far enough
// apart to avoid slivers.
#pragma once

#include <array>
#include <vector>

#include "surface/mesh/edge_table.h"

namespace wirewarp {

/// Barycentric coordinates in a face.
using Shares = std::array<double, 3>;

struct Site {
  std::vector<int> vertices;   // one vertex; the ends of an edge, smaller first; or the corners of a face
  std::vector<double> shares;  // weight of each of these vertices
  int edge = -1;               // the edge that contains the site between its ends; otherwise -1
  int face = -1;               // the face that contains the site strictly inside; otherwise -1
};

class PathSites {
 public:
  /// Sites 0 to num_vertices - 1 are the vertices. The arguments must outlive the object.
  PathSites(const Triangles& faces, const EdgeTable& edges, int num_vertices, double snap);

  /// Returns the site at a point, moved to an edge, a vertex or another site within reach.
  int add(int face, const Shares& shares);

  /// Returns a new site strictly inside a face, without moving it to other sites.
  int add_inside(int face, const Shares& shares);

  int size() const { return static_cast<int>(sites_.size()); }
  const Site& operator[](int site) const { return sites_[site]; }

  /// Returns the sites on the border of a face, starting at its first corner, then the sites inside.
  std::vector<int> of_face(int face) const;

  /// Returns the barycentric coordinates of a site inside a face or on its border.
  Shares shares_in(int site, int face) const;

  /// Returns the faces that contain a site, inside or on their border, ascending.
  std::vector<int> faces_at(int site) const;

  /// Returns the edge that contains both sites, possibly as its ends; -1 if there is no such edge.
  int common_edge(int a, int b) const;

  /// Returns the edges with sites between their ends, ascending.
  std::vector<int> divided_edges() const;

  /// Returns the sites along an edge, including its ends, from the end with the smaller index.
  std::vector<int> along(int edge) const;

  /// Returns the sites along a side of a face, including its ends, from the corner with the side's number.
  std::vector<int> along_side(int face, int side) const;

  double snap() const { return snap_; }

 private:
  int add_on_edge(int edge, double share);
  int find_inside(int face, const Shares& shares) const;

  const Triangles& faces_;
  const EdgeTable& edges_;
  const double snap_;
  std::vector<Site> sites_;
  std::vector<std::vector<int>> on_edge_;  // per edge: the sites between its ends, from the end with the smaller index
  std::vector<std::vector<int>> in_face_;  // per face: the sites strictly inside
  std::vector<std::vector<int>> faces_of_vertex_;
};

}  // namespace wirewarp
