// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "base/disjoint_sets.h"
#include "base/planar.h"
#include "random_input.h"

namespace wirewarp::test {
namespace {

constexpr double kThinnest = 1e-4;  // smallest height of a face over its longest side

using Face = std::array<int, 3>;
using Faces = std::vector<Face>;
using Point = Eigen::Matrix<long double, 2, 1>;

long double cross(const Point& a, const Point& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Returns whether p is inside the circle through the corners of a counter-clockwise triangle.
bool is_in_circle(const std::vector<Point>& points, const Face& triangle, const Point& p) {
  const Point a = points[triangle[0]] - p, b = points[triangle[1]] - p, c = points[triangle[2]] - p;
  return a.squaredNorm() * cross(b, c) + b.squaredNorm() * cross(c, a) + c.squaredNorm() * cross(a, b) > 0;
}

/// Returns the Delaunay triangulation of points in general position, counter-clockwise (Bowyer 1981, Watson 1981). The
/// time grows with the square of the number of points. Slivers may be missing at the hull.
Faces delaunay(const std::vector<Eigen::Vector2d>& points) {
  Eigen::Vector2d low = points.front(), high = points.front();
  std::vector<Point> all;
  for (const Eigen::Vector2d& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
    all.emplace_back(p.cast<long double>());
  }
  const int count = static_cast<int>(points.size());
  const Point middle = ((low + high) / 2).cast<long double>();
  const long double far = 1000 * static_cast<long double>((high - low).norm());
  for (const Point& direction : {Point(-1, -1), Point(1, -1), Point(0, 1)}) all.emplace_back(middle + far * direction);

  Faces triangles{{count, count + 1, count + 2}};
  for (int v = 0; v < count; ++v) {
    const auto keeps = [&](const Face& t) { return !is_in_circle(all, t, all[v]); };
    const auto cavity = std::stable_partition(triangles.begin(), triangles.end(), keeps);
    std::set<std::pair<int, int>> rim;  // border of the cavity, directed, with the cavity on the left
    for (auto t = cavity; t != triangles.end(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        const int from = (*t)[k], to = (*t)[(k + 1) % 3];
        if (rim.erase({to, from}) == 0) rim.insert({from, to});
      }
    }
    triangles.erase(cavity, triangles.end());
    for (const auto& [from, to] : rim) triangles.push_back({from, to, v});
  }
  triangles.erase(std::remove_if(triangles.begin(), triangles.end(),
                                 [&](const Face& t) { return *std::max_element(t.begin(), t.end()) >= count; }),
                  triangles.end());
  return triangles;
}

/// The area inside an outline with random bays and outside of round holes.
class Domain {
 public:
  explicit Domain(RandomStream& random) : bays_(random.chance(0.5) ? random.between(0, 0.6) : 0) {
    num_bays_ = random.whole(2, 6);
    turn_ = random.between(0, kPi);
    const int num_holes = random.chance(0.5) ? 0 : random.whole(1, 4);
    for (int i = 0; i < num_holes; ++i) {
      holes_.push_back({{random.between(-0.6, 0.6), random.between(-0.6, 0.6)}, random.between(0.05, 0.3)});
    }
  }

  bool contains(const Eigen::Vector2d& p) const {
    const double angle = std::atan2(p.y(), p.x());
    if (bays_ > 0 && p.norm() > 1 - bays_ * (0.5 + 0.5 * std::cos(num_bays_ * angle + turn_))) return false;
    return std::none_of(holes_.begin(), holes_.end(),
                        [&](const Hole& hole) { return (p - hole.center).norm() < hole.radius; });
  }

 private:
  struct Hole {
    Eigen::Vector2d center;
    double radius;
  };
  double bays_;  // depth of the bays
  int num_bays_;
  double turn_;
  std::vector<Hole> holes_;
};

/// Returns points in the square of side 2: evenly spread, or in clusters, so that faces differ in size and shape.
std::vector<Eigen::Vector2d> random_points(RandomStream& random, int count) {
  std::vector<Eigen::Vector2d> points;
  const double clustered = random.chance(0.3) ? random.uniform() : 0;
  const double spread = random.across_scales(1e-3, 0.3);
  for (int i = 0; i < count; ++i) {
    if (!points.empty() && random.chance(clustered)) {
      const Eigen::Vector2d center = random.pick(points);
      points.emplace_back(center.x() + spread * random.between(-1, 1), center.y() + spread * random.between(-1, 1));
    } else {
      points.emplace_back(random.between(-1, 1), random.between(-1, 1));
    }
  }
  return points;
}

bool is_thin(const MeshPart& part, const Face& face) {
  const auto corner = [&](std::size_t k) { return part.vertices[face[k]]; };
  const Eigen::Vector3d ab = corner(1) - corner(0), bc = corner(2) - corner(1), ca = corner(0) - corner(2);
  const double longest = std::max({ab.norm(), bc.norm(), ca.norm()});
  return ab.cross(ca).norm() < kThinnest * longest * longest;
}

/// Returns the largest set of faces connected across edges.
Faces largest_region(const Faces& faces) {
  DisjointSets groups(faces.size());
  std::map<std::pair<int, int>, int> side;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = faces[f][k], b = faces[f][(k + 1) % 3];
      const auto [other, is_new] = side.insert({std::minmax(a, b), static_cast<int>(f)});
      if (!is_new) groups.unite(static_cast<int>(f), other->second);
    }
  }
  int count = 0;
  const std::vector<int> group = groups.number(count);
  std::vector<int> size(count);
  for (const int g : group) ++size[g];
  const auto largest = std::max_element(size.begin(), size.end()) - size.begin();
  Faces kept;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (group[f] == largest) kept.push_back(faces[f]);
  }
  return kept;
}

/// Removes the faces around vertices where faces touch without a common edge, and keeps the largest connected region.
/// Repeats until no such vertex remains.
Faces without_pinches(Faces faces) {
  for (bool has_changed = true; has_changed;) {
    faces = largest_region(faces);
    std::map<int, int> outline_edges_at;
    std::map<std::pair<int, int>, int> count;
    for (const Face& face : faces) {
      for (std::size_t k = 0; k < 3; ++k) ++count[std::minmax(face[k], face[(k + 1) % 3])];
    }
    for (const auto& [edge, times] : count) {
      if (times > 1) continue;
      ++outline_edges_at[edge.first];
      ++outline_edges_at[edge.second];
    }
    const auto is_pinched = [&](const Face& face) {
      return std::any_of(face.begin(), face.end(), [&](int v) { return outline_edges_at[v] > 2; });
    };
    const auto kept = std::stable_partition(faces.begin(), faces.end(), [&](const Face& f) { return !is_pinched(f); });
    has_changed = kept != faces.end() && kept != faces.begin();
    if (kept == faces.begin()) return {faces.front()};
    faces.erase(kept, faces.end());
  }
  return faces;
}

MeshPart only_used_vertices(const MeshPart& part) {
  MeshPart used;
  std::map<int, int> place;
  for (const Face& face : part.faces) {
    Face renumbered{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [known, is_new] = place.insert({face[k], static_cast<int>(used.vertices.size())});
      if (is_new) used.vertices.push_back(part.vertices[face[k]]);
      renumbered[k] = known->second;
    }
    used.faces.push_back(renumbered);
  }
  return used;
}

}  // namespace

MeshPart rough_sheet(RandomStream& random, std::string& description) {
  const Domain domain(random);
  const std::vector<Eigen::Vector2d> points =
      random_points(random, static_cast<int>(random.across_scales(5, random.chance(0.1) ? 400 : 60)));
  const double squeeze = random.chance(0.4) ? random.across_scales(kThinnest, 1) : 1;  // makes needles of all faces
  const double rough = random.chance(0.2) ? 0 : random.across_scales(1e-3, 3);         // height steps between vertices
  const double swell = random.chance(0.5) ? random.between(-2, 2) : 0;
  MeshPart part;
  for (const Eigen::Vector2d& p : points) {
    const double height = swell * std::cos(2 * p.x()) * std::cos(1.5 * p.y()) + rough * random.between(-1, 1);
    part.vertices.emplace_back(p.x(), squeeze * p.y(), height);
  }
  for (const Face& face : delaunay(points)) {
    const Eigen::Vector2d middle = (points[face[0]] + points[face[1]] + points[face[2]]) / 3;
    if (domain.contains(middle) && !is_thin(part, face)) part.faces.push_back(face);
  }
  description += " rough-sheet";
  if (part.faces.empty()) return {{{0, 0, 0}, {1, 0, rough}, {0, 1, 0}}, {{0, 1, 2}}};
  part.faces = without_pinches(std::move(part.faces));
  return only_used_vertices(part);
}

}  // namespace wirewarp::test
