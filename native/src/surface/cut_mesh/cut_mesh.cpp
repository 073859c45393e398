// SPDX-License-Identifier: GPL-3.0-or-later
// Turns paths into sites, divides the lines between sites where they cross, and triangulates each face that contains
// sites or lines.
#include "wirewarp/cut_mesh.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "base/arguments.h"
#include "base/sentence.h"
#include "surface/check_input/check_input.h"
#include "surface/cut_mesh/path_lines.h"

namespace wirewarp {
namespace {

/// Rounding error of barycentric coordinates from callers that use float32. Each coordinate may be below 0 by this
/// much, and the sum of the three may differ from 1 by this much.
constexpr double kRounded = 1e-6;

std::string name_of(std::size_t path) { return "paths[" + std::to_string(path) + "]"; }

Shares clean(const Eigen::RowVector3d& coordinates) {
  const Eigen::Array3d positive = coordinates.array().max(0);
  const double sum = positive.sum();
  if (sum == 1) return {positive[0], positive[1], positive[2]};
  return {positive[0] / sum, positive[1] / sum, positive[2] / sum};
}

void check_faces(const FlattenInput& input) {
  check_mesh(input);
  std::vector<int> repeated;
  for (int f = 0; f < static_cast<int>(input.faces.rows()); ++f) {
    const auto& corners = input.faces.row(f);
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) repeated.push_back(f);
  }
  if (!repeated.empty()) throw FlattenError(ErrorCode::repeated_vertex_in_face, ErrorArguments{}, {{}, {}, repeated});
}

void check_paths(const std::vector<SurfacePath>& paths, int num_faces, double snap) {
  constexpr double kLeast = 1e-4;  // if points were nearer, areas would come near the rounding limit kInLine
  constexpr double kMost = 0.25;   // with a larger value, a point could move past the middle between two other points
  if (!(snap >= kLeast && snap <= kMost)) throw wrong_option("snap", shortest(snap), "be from 0.0001 to 0.25");
  for (std::size_t p = 0; p < paths.size(); ++p) {
    check_surface_path(paths[p]);
    for (const int face : paths[p].faces) {
      if (face < num_faces) continue;
      throw wrong_option(name_of(p), "a line in face " + std::to_string(face),
                         "use the faces of the mesh, 0 to " + std::to_string(num_faces - 1));
    }
  }
}

class MeshCut {
 public:
  MeshCut(const Positions3& vertices, const Triangles& faces, const std::vector<SurfacePath>& paths, double snap)
      : vertices_(vertices),
        faces_(faces),
        edges_(faces, static_cast<int>(vertices.rows())),
        sites_(faces, edges_, static_cast<int>(vertices.rows()), snap),
        lines_(sites_) {
    for (std::size_t p = 0; p < paths.size(); ++p) draw(paths[p], name_of(p));
    lines_.divide();
  }

  CutMesh cut() const {
    CutMesh result;
    take_vertices(result);
    take_faces(result);
    take_edges(result);
    for (const int edge : sites_.divided_edges()) result.sources.divided_edges.push_back(sites_.along(edge));
    return result;
  }

 private:
  using Line = std::array<int, 2>;

  void draw(const SurfacePath& path, const std::string& name);
  int common_face(int a, int b, int preferred) const;
  void take_vertices(CutMesh& result) const;
  void take_faces(CutMesh& result) const;
  void take_edges(CutMesh& result) const;
  std::optional<std::vector<std::array<int, 3>>> parts_of(int face) const;

  const Positions3& vertices_;
  const Triangles& faces_;
  const EdgeTable edges_;
  PathSites sites_;
  PathLines lines_;
  std::vector<std::vector<int>> drawn_;  // sites of each path; consecutive sites differ
};

/// Returns a face with both sites inside or on its border, `preferred` if possible; -1 if there is no such face.
int MeshCut::common_face(int a, int b, int preferred) const {
  const std::vector<int> first = sites_.faces_at(a), second = sites_.faces_at(b);
  std::vector<int> common;
  std::set_intersection(first.begin(), first.end(), second.begin(), second.end(), std::back_inserter(common));
  if (std::binary_search(common.begin(), common.end(), preferred)) return preferred;
  return common.empty() ? -1 : common.front();
}

void MeshCut::draw(const SurfacePath& path, const std::string& name) {
  std::vector<int> line;
  for (std::size_t i = 0; i < path.faces.size(); ++i) {
    const int site = sites_.add(path.faces[i], clean(path.coordinates.row(static_cast<Eigen::Index>(i))));
    if (!line.empty() && line.back() == site) continue;
    if (!line.empty()) {
      const int face = common_face(line.back(), site, path.faces[i]);
      if (face < 0) {
        throw wrong_option(
            name, "a line whose points " + std::to_string(i - 1) + " and " + std::to_string(i) + " have no common face",
            "have a point on each edge that it crosses");
      }
      lines_.draw(face, line.back(), site);
    }
    line.push_back(site);
  }
  if (line.size() < 2) {
    throw wrong_option(name, "a line whose points all snap to one point", "be longer");
  }
  drawn_.push_back(std::move(line));
}

void MeshCut::take_vertices(CutMesh& result) const {
  const int count = sites_.size();
  result.vertices.resize(count, 3);
  result.sources.vertices.resize(count, 3);
  result.sources.vertex_weights.setZero(count, 3);
  for (int site = 0; site < count; ++site) {
    const Site& at = sites_[site];
    Eigen::RowVector3d place = Eigen::RowVector3d::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
      const bool is_used = k < at.vertices.size();
      result.sources.vertices(site, static_cast<Eigen::Index>(k)) = is_used ? at.vertices[k] : at.vertices[0];
      if (!is_used) continue;
      result.sources.vertex_weights(site, static_cast<Eigen::Index>(k)) = at.shares[k];
      place += at.shares[k] * vertices_.row(at.vertices[k]);
    }
    result.vertices.row(site) = place;
  }
}

/// Returns the sites of the triangles into which a face is divided, or nothing if it is not divided.
std::optional<std::vector<std::array<int, 3>>> MeshCut::parts_of(int face) const {
  const std::vector<int> sites = sites_.of_face(face);
  if (sites.size() == 3) return std::nullopt;
  FaceToDivide parts;
  for (int side = 0; side < 3; ++side) {
    parts.sides.push_back({(side + 2) % 3, side});  // the corner is on both of these sides
    parts.sides.insert(parts.sides.end(), sites_.along_side(face, side).size() - 2, {side, side});
  }
  parts.places.resize(static_cast<Eigen::Index>(sites.size()), 3);
  for (std::size_t i = 0; i < sites.size(); ++i) {
    const Shares shares = sites_.shares_in(sites[i], face);
    parts.points.push_back(point_in(shares));
    parts.places.row(static_cast<Eigen::Index>(i)).setZero();
    for (int k = 0; k < 3; ++k)
      parts.places.row(static_cast<Eigen::Index>(i)) += shares[k] * vertices_.row(faces_(face, k));
  }
  const auto place_of = [&](int site) {
    return static_cast<int>(std::find(sites.begin(), sites.end(), site) - sites.begin());
  };
  const auto lines = lines_.lines().find(face);
  if (lines != lines_.lines().end()) {
    for (const Line& line : lines->second) {
      const auto [first, last] = std::minmax({place_of(line[0]), place_of(line[1])});
      parts.lines.insert({first, last});
    }
  }
  std::vector<std::array<int, 3>> triangles = triangulate(parts);
  for (std::array<int, 3>& triangle : triangles) {
    for (int& corner : triangle) corner = sites[corner];
  }
  return triangles;
}

void MeshCut::take_faces(CutMesh& result) const {
  std::vector<std::array<int, 3>> faces, more;
  std::vector<int> sources, sources_of_more;
  for (int f = 0; f < static_cast<int>(faces_.rows()); ++f) {
    sources.push_back(f);
    const auto parts = parts_of(f);
    if (!parts) {
      faces.push_back({faces_(f, 0), faces_(f, 1), faces_(f, 2)});
      continue;
    }
    faces.push_back(parts->front());
    more.insert(more.end(), parts->begin() + 1, parts->end());
    sources_of_more.insert(sources_of_more.end(), parts->size() - 1, f);
  }
  faces.insert(faces.end(), more.begin(), more.end());
  sources.insert(sources.end(), sources_of_more.begin(), sources_of_more.end());
  const auto count = static_cast<Eigen::Index>(faces.size());
  result.faces.resize(count, 3);
  result.sources.corner_weights.resize(count, 9);
  for (Eigen::Index f = 0; f < count; ++f) {
    for (int k = 0; k < 3; ++k) {
      result.faces(f, k) = faces[f][k];
      const Shares shares = sites_.shares_in(faces[f][k], sources[f]);
      for (int j = 0; j < 3; ++j) result.sources.corner_weights(f, 3 * k + j) = shares[j];
    }
  }
  result.sources.faces = std::move(sources);
}

void MeshCut::take_edges(CutMesh& result) const {
  std::set<Line> known;
  for (std::size_t p = 0; p < drawn_.size(); ++p) {
    std::vector<int> line{drawn_[p].front()};
    for (std::size_t i = 1; i < drawn_[p].size(); ++i) lines_.append_sites(drawn_[p][i - 1], drawn_[p][i], line);
    for (std::size_t i = 1; i < line.size(); ++i) {
      const auto [first, last] = std::minmax(line[i - 1], line[i]);
      if (!known.insert({first, last}).second) continue;
      result.edges.push_back({line[i - 1], line[i]});
      result.sources.edge_paths.push_back(static_cast<int>(p));
    }
  }
}

}  // namespace

void check_surface_path(const SurfacePath& path) {
  const auto count = static_cast<Eigen::Index>(path.faces.size());
  if (count < 2) throw wrong_option("path", "too short", "have two points or more");
  if (path.coordinates.rows() != count) {
    throw wrong_option(
        "path",
        "a line of " + std::to_string(count) + " faces and " + std::to_string(path.coordinates.rows()) + " coordinates",
        "have the same number of both");
  }
  for (Eigen::Index i = 0; i < count; ++i) {
    const int face = path.faces[static_cast<std::size_t>(i)];
    if (face < 0) throw wrong_option("path", "a line in face " + std::to_string(face), "use faces from 0 on");
    const Eigen::RowVector3d shares = path.coordinates.row(i);
    if (shares.allFinite() && shares.minCoeff() >= -kRounded && std::abs(shares.sum() - 1) <= kRounded) continue;
    throw wrong_option("path",
                       "at point " + std::to_string(i) + " at " + rounded(shares[0]) + ", " + rounded(shares[1]) +
                           ", " + rounded(shares[2]),
                       "have coordinates of 0 or more with the sum 1");
  }
}

CutMesh cut_mesh(const Positions3& vertices, const Triangles& faces, const std::vector<SurfacePath>& paths,
                 double snap) {
  FlattenInput input;
  input.vertices = vertices;
  input.faces = faces;
  check_faces(input);
  check_paths(paths, static_cast<int>(faces.rows()), snap);
  return MeshCut(vertices, faces, paths, snap).cut();
}

}  // namespace wirewarp
