// SPDX-License-Identifier: GPL-3.0-or-later
// The straight lines of paths within faces, divided where they cross or pass close to a site.
#pragma once

#include <array>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "surface/cut_mesh/path_sites.h"
#include "surface/cut_mesh/triangulate_face.h"

namespace wirewarp {

inline FacePoint point_in(const Shares& shares) { return {shares[1], shares[2]}; }

class PathLines {
 public:
  explicit PathLines(PathSites& sites) : sites_(sites) {}

  /// Draws a line between two sites of a face. Lines along edges are ignored.
  void draw(int face, int from, int to);

  /// Divides the lines of all faces until no two lines cross. Throws invalid_option if this takes too many divisions.
  void divide();

  /// Appends the sites along a line, except its start: the sites that divide it, the sites between its ends if it runs
  /// along an edge, and its end.
  void append_sites(int from, int to, std::vector<int>& line) const;

  /// Returns the lines of each face, which do not cross after divide(). The smaller site of a line is first.
  const std::map<int, std::set<std::array<int, 2>>>& lines() const { return lines_; }

 private:
  using Line = std::array<int, 2>;

  bool divide_once(int face, const std::set<Line>& lines);
  void divide_at(int face, Line line, int site);
  bool is_between(int face, int site, const Line& line) const;
  int crossing_of(int face, const Line& one, const Line& other);
  int site_close_by(int face, const Line& line) const;
  FacePoint point(int face, int site) const { return point_in(sites_.shares_in(site, face)); }

  PathSites& sites_;
  std::map<int, std::set<Line>> lines_;  // keyed by face
  std::map<Line, int> divided_;          // the site that divided each removed line
};

}  // namespace wirewarp
