// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/cut_mesh/path_sites.h"

#include <algorithm>
#include <cmath>

namespace wirewarp {
namespace {

/// Factor on `snap` that gives the reach of a site. A site at a distance of exactly `snap` is out of reach, even with
/// rounded coordinates, so that snapped paths do not move again.
constexpr double kRoundedReach = 1 - 1e-9;

}  // namespace

PathSites::PathSites(const Triangles& faces, const EdgeTable& edges, int num_vertices, double snap)
    : faces_(faces),
      edges_(edges),
      snap_(snap),
      on_edge_(edges.num_edges()),
      in_face_(faces.rows()),
      faces_of_vertex_(num_vertices) {
  for (int v = 0; v < num_vertices; ++v) sites_.push_back({{v}, {1}});
  for (int f = 0; f < static_cast<int>(faces.rows()); ++f) {
    for (const int v : faces.row(f)) faces_of_vertex_[v].push_back(f);
  }
}

int PathSites::add(int face, const Shares& shares) {
  const double reach = snap_ * kRoundedReach;
  const int least = static_cast<int>(std::min_element(shares.begin(), shares.end()) - shares.begin());
  if (shares[least] >= reach) {
    const int known = find_inside(face, shares);
    return known >= 0 ? known : add_inside(face, shares);
  }
  const int from = (least + 1) % 3, to = (least + 2) % 3;
  const double share = shares[to] / (shares[from] + shares[to]);
  if (share < reach) return faces_(face, from);
  if (1 - share < reach) return faces_(face, to);
  const int edge = edges_.edge_of_side(3 * face + from);
  return add_on_edge(edge, edges_.vertices(edge)[1] == faces_(face, to) ? share : 1 - share);
}

/// Returns the site within reach of a point on an edge, or a new site. share: position along the edge, 0 at its first
/// end.
int PathSites::add_on_edge(int edge, double share) {
  std::vector<int>& known = on_edge_[edge];
  auto place = known.begin();
  for (; place != known.end(); ++place) {
    const double other = sites_[*place].shares[1];
    if (std::abs(other - share) < snap_ * kRoundedReach) return *place;
    if (other > share) break;
  }
  if (place != known.end() && sites_[*place].shares[1] - share < snap_ * kRoundedReach) return *place;
  const auto& [first, second] = edges_.vertices(edge);
  sites_.push_back({{first, second}, {1 - share, share}, edge});
  known.insert(place, size() - 1);
  return size() - 1;
}

/// Returns the site in a face that is within reach of a point; -1 if there is none.
int PathSites::find_inside(int face, const Shares& shares) const {
  for (const int site : in_face_[face]) {
    double apart = 0;
    for (std::size_t k = 0; k < 3; ++k) apart = std::max(apart, std::abs(sites_[site].shares[k] - shares[k]));
    if (apart < snap_ * kRoundedReach) return site;
  }
  return -1;
}

int PathSites::add_inside(int face, const Shares& shares) {
  sites_.push_back({{faces_(face, 0), faces_(face, 1), faces_(face, 2)}, {shares.begin(), shares.end()}, -1, face});
  in_face_[face].push_back(size() - 1);
  return size() - 1;
}

Shares PathSites::shares_in(int site, int face) const {
  Shares shares{};
  for (std::size_t i = 0; i < sites_[site].vertices.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      if (faces_(face, k) == sites_[site].vertices[i]) shares[k] = sites_[site].shares[i];
    }
  }
  return shares;
}

std::vector<int> PathSites::faces_at(int site) const {
  const Site& at = sites_[site];
  if (at.face >= 0) return {at.face};
  if (at.edge < 0) return faces_of_vertex_[at.vertices[0]];
  std::vector<int> faces;
  for (int j = 0; j < edges_.num_sides(at.edge); ++j) faces.push_back(edges_.side(at.edge, j) / 3);
  return faces;
}

int PathSites::common_edge(int a, int b) const {
  const Site &first = sites_[a], &second = sites_[b];
  if (first.face >= 0 || second.face >= 0) return -1;
  const auto has_end = [&](int edge, int v) { return edges_.vertices(edge)[0] == v || edges_.vertices(edge)[1] == v; };
  if (first.edge >= 0 && second.edge >= 0) return first.edge == second.edge ? first.edge : -1;
  if (first.edge >= 0) return has_end(first.edge, second.vertices[0]) ? first.edge : -1;
  if (second.edge >= 0) return has_end(second.edge, first.vertices[0]) ? second.edge : -1;
  return edges_.find(first.vertices[0], second.vertices[0]);
}

std::vector<int> PathSites::divided_edges() const {
  std::vector<int> edges;
  for (int edge = 0; edge < edges_.num_edges(); ++edge) {
    if (!on_edge_[edge].empty()) edges.push_back(edge);
  }
  return edges;
}

std::vector<int> PathSites::along(int edge) const {
  const auto& [first, second] = edges_.vertices(edge);
  std::vector<int> line{first};
  line.insert(line.end(), on_edge_[edge].begin(), on_edge_[edge].end());
  line.push_back(second);
  return line;
}

std::vector<int> PathSites::along_side(int face, int side) const {
  std::vector<int> line = along(edges_.edge_of_side(3 * face + side));
  if (line.front() != faces_(face, side)) std::reverse(line.begin(), line.end());
  return line;
}

std::vector<int> PathSites::of_face(int face) const {
  std::vector<int> sites;
  for (int side = 0; side < 3; ++side) {
    const std::vector<int> line = along_side(face, side);
    sites.insert(sites.end(), line.begin(), line.end() - 1);
  }
  sites.insert(sites.end(), in_face_[face].begin(), in_face_[face].end());
  return sites;
}

}  // namespace wirewarp
