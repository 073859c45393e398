// SPDX-License-Identifier: GPL-3.0-or-later
#include "cuts/propose/relax_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "newton/coarsen/coarse_chart.h"
#include "surface/mesh/geometry.h"

namespace wirewarp {
namespace {

/// On a line along edges, the points to move are at the shares kShares of each edge. A line across triangles has
/// kPointsPerEdge points to move per edge length. In both cases, points are half an edge length apart.
constexpr double kShares[] = {0.25, 0.75};
constexpr double kPointsPerEdge = 2;

/// A point to move starts at least this share of its section away from both ends of the section, because an end may be
/// a vertex.
constexpr double kFromEnd = 0.1;

/// A point moves by this share of the sum of the vectors to both neighbors. With 1/2, a zigzag would not fade.
constexpr double kStep = 1.0 / 3;

/// The walk from a point to the next point of a line ends after this many edge lengths. Points are closer together, so
/// a longer walk has met an obstacle.
constexpr double kReach = 4;

/// If a line crosses an edge nearer to a vertex than this share of the edge, the line leads through the vertex. The
/// share is twice the snap of cut_mesh(), so that cutting does not bend the line again.
constexpr double kSnap = 0.1;

/// A line is not relaxed if it becomes shorter than this share of the longest edge at its ends, because cut_mesh()
/// could not cut it.
constexpr double kShortest = 0.25;

bool is_along_edges(const SurfaceLine& line) {
  return std::all_of(line.sections.begin(), line.sections.end(),
                     [](const LineSection& section) { return section.edge.is_valid(); });
}

std::vector<EdgeHandle> sorted_edges(const SurfaceLine& line) {
  std::vector<EdgeHandle> edges;
  for (const LineSection& section : line.sections) {
    if (section.edge.is_valid()) edges.push_back(section.edge);
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

double edge_length_for(const HalfEdgeMesh& mesh, const std::vector<SurfaceLine>& lines) {
  if (!std::all_of(lines.begin(), lines.end(), is_along_edges)) return typical_edge_length(mesh);
  double length = 0;
  std::size_t count = 0;
  for (const SurfaceLine& line : lines) {
    for (const LineSection& section : line.sections) length += std::abs(section.to - section.from);
    count += line.sections.size();
  }
  return length / static_cast<double>(count);
}

double longest_edge_at(const HalfEdgeMesh& mesh, const SurfacePoint& point) {
  double longest = 0;
  for (const FaceHandle f : faces_at(mesh, point)) {
    for (const HalfedgeHandle h : mesh.fh_range(f)) longest = std::max(longest, edge_length(mesh, h));
  }
  return longest;
}

bool is_connected(const HalfEdgeMesh& mesh, const RelaxedLine& line) {
  std::vector<std::vector<FaceHandle>> faces;
  if (!line.is_closed) faces.push_back(faces_at(mesh, line.start));
  for (const PathPoint& point : line.between) faces.push_back(faces_at(mesh, point));
  if (!line.is_closed) faces.push_back(faces_at(mesh, line.end));
  for (std::size_t i = 1; i < faces.size(); ++i) {
    if (!have_common_face(faces[i - 1], faces[i])) return false;
  }
  return true;
}

/// The line must not be closed.
double length_of_line(const HalfEdgeMesh& mesh, const RelaxedLine& line) {
  HalfEdgeMesh::Point last = position(mesh, line.start);
  double length = 0;
  for (const PathPoint& point : line.between) {
    const HalfEdgeMesh::Point place = position(mesh, point);
    length += (place - last).norm();
    last = place;
  }
  return length + (position(mesh, line.end) - last).norm();
}

VertexHandle near_vertex(const HalfEdgeMesh& mesh, const PathPoint& point) {
  if (point.is_vertex()) return point.vertex;
  if (point.t < kSnap) return mesh.from_vertex_handle(point.half_edge);
  return point.t > 1 - kSnap ? mesh.to_vertex_handle(point.half_edge) : VertexHandle();
}

bool is_on_edge_at(const HalfEdgeMesh& mesh, const PathPoint& point, VertexHandle v) {
  return !point.is_vertex() &&
         (mesh.from_vertex_handle(point.half_edge) == v || mesh.to_vertex_handle(point.half_edge) == v);
}

bool are_on_one_edge(const HalfEdgeMesh& mesh, const PathPoint& a, const PathPoint& b) {
  return !a.is_vertex() && !b.is_vertex() && mesh.edge_handle(a.half_edge) == mesh.edge_handle(b.half_edge);
}

/// Adds a point to a path, and removes unnecessary crossings. A crossing is unnecessary if the path immediately crosses
/// the same edge again, or leads through an end of this edge.
void append(const HalfEdgeMesh& mesh, const PathPoint& point, MeshPath& path) {
  const VertexHandle v = near_vertex(mesh, point);
  if (!v.is_valid()) {
    if (!path.empty() && are_on_one_edge(mesh, path.back(), point)) {
      path.pop_back();
    } else if (path.empty() || !path.back().is_vertex() || !is_on_edge_at(mesh, point, path.back().vertex)) {
      path.push_back(point);
    }
    return;
  }
  while (!path.empty() && is_on_edge_at(mesh, path.back(), v)) path.pop_back();
  if (!path.empty() && path.back().vertex == v) return;
  if (path.size() > 1 && path.back().is_vertex() && path[path.size() - 2].vertex == v) {
    path.pop_back();
    return;
  }
  path.push_back(PathPoint::at_vertex(v));
}

/// Joins the end of a path to its beginning by the rules of append(). Returns whether a closed path remains.
bool close(const HalfEdgeMesh& mesh, MeshPath& path) {
  while (path.size() > 2) {
    MeshPath joined = path;
    append(mesh, path.front(), joined);
    if (joined.size() > path.size()) break;
    if (path.front().is_vertex()) {
      joined.pop_back();  // the same vertex as the first point
    } else {
      joined.erase(joined.begin());
    }
    path = std::move(joined);
  }
  if (path.size() < 3) return false;
  path.push_back(path.front());
  return true;
}

}  // namespace

LineNetwork::LineNetwork(const HalfEdgeMesh& mesh, const std::vector<SurfaceLine>& lines,
                         const std::vector<char>& barriers)
    : mesh_(mesh), barriers_(barriers), walk_(mesh, barriers), edge_length_(edge_length_for(mesh, lines)) {
  std::map<int, int> num_ends;
  for (const SurfaceLine& line : lines) {
    ++num_ends[line.first];
    ++num_ends[line.last];
  }
  for (const SurfaceLine& line : lines) {
    const VertexHandle start = line.sections.front().vertex_from;
    const bool is_ring = line.first == line.last && num_ends[line.first] == 2;
    add_line(line, is_ring && !(start.is_valid() && touches_barrier(start)));
  }
  for (const auto& [end, point] : junctions_) {
    if (points_[point].lines.size() < 2) points_[point].is_fixed = true;
  }
}

bool LineNetwork::touches_barrier(VertexHandle v) const {
  return mesh_.is_boundary(v) ||
         std::any_of(mesh_.cve_begin(v), mesh_.cve_end(v), [&](EdgeHandle e) { return barriers_[e.idx()] != 0; });
}

/// Returns whether a relaxed line follows an edge of a barrier or outline that the original line does not follow. path:
/// points of the relaxed line.
bool LineNetwork::runs_along_barrier(std::size_t line, const MeshPath& path) const {
  for (std::size_t i = 1; i < path.size(); ++i) {
    if (!path[i - 1].is_vertex() || !path[i].is_vertex()) continue;
    const EdgeHandle e = mesh_.edge_handle(mesh_.find_halfedge(path[i - 1].vertex, path[i].vertex));
    const bool is_barrier = barriers_[e.idx()] != 0 || mesh_.is_boundary(e);
    if (is_barrier && !std::binary_search(edges_[line].begin(), edges_[line].end(), e)) return true;
  }
  return false;
}

void LineNetwork::add_line(const SurfaceLine& line, bool is_ring) {
  std::vector<std::size_t> points;
  const auto add_end = [&](int end, const SurfacePoint& place) {
    const auto [known, is_new] = junctions_.try_emplace(end, points_.size());
    if (is_new) points_.push_back({place, {}, place.vertex.is_valid() && touches_barrier(place.vertex)});
    points_[known->second].lines.push_back(lines_.size());
    points.push_back(known->second);
  };
  const auto place_of = [](VertexHandle v, FaceHandle f, Planar place) {
    return v.is_valid() ? SurfacePoint::at_vertex(v) : SurfacePoint::in_face(f, place);
  };
  const LineSection& first = line.sections.front();
  if (!is_ring) add_end(line.first, place_of(first.vertex_from, first.face, first.from));
  for (std::size_t i = 0, begin = 0; i < line.sections.size(); ++i) {
    const LineSection& section = line.sections[i];
    const bool is_last = i + 1 == line.sections.size();
    const bool is_fixed = !is_last && section.vertex_to.is_valid() && touches_barrier(section.vertex_to);
    if (!is_last && !is_fixed) continue;
    add_points(line, begin, i + 1, points);
    begin = i + 1;
    if (is_fixed) {
      points.push_back(points_.size());
      points_.push_back({SurfacePoint::at_vertex(section.vertex_to), {lines_.size()}, true});
    }
  }
  const LineSection& last = line.sections.back();
  if (is_ring) {
    points.push_back(points.front());
  } else {
    add_end(line.last, place_of(last.vertex_to, last.face, last.to));
  }
  lines_.push_back(std::move(points));
  is_ring_.push_back(is_ring ? 1 : 0);
  edges_.push_back(sorted_edges(line));
}

/// Adds the points to move in the sections from `begin` to before `end`; none for a single edge of a barrier.
void LineNetwork::add_points(const SurfaceLine& line, std::size_t begin, std::size_t end,
                             std::vector<std::size_t>& points) {
  const EdgeHandle edge = line.sections[begin].edge;
  if (end == begin + 1 && edge.is_valid() && barriers_[edge.idx()] != 0) return;
  const auto add = [&](const LineSection& section, double share) {
    points.push_back(points_.size());
    points_.push_back({SurfacePoint::in_face(section.face, section.from + share * (section.to - section.from)),
                       {lines_.size()},
                       false});
  };
  if (is_along_edges(line)) {
    for (std::size_t i = begin; i < end; ++i) {
      for (const double share : kShares) add(line.sections[i], share);
    }
    return;
  }
  double length = 0;
  for (std::size_t i = begin; i < end; ++i) length += std::abs(line.sections[i].to - line.sections[i].from);
  const double count = std::max(std::round(length * kPointsPerEdge / edge_length_), 1.0);
  double passed = 0, k = 0.5;
  for (std::size_t i = begin; i < end; ++i) {
    const LineSection& section = line.sections[i];
    const double own = std::abs(section.to - section.from);
    for (; k < count && (k * length <= (passed + own) * count || i + 1 == end); ++k) {
      add(section, std::clamp((k * length / count - passed) / own, kFromEnd, 1 - kFromEnd));
    }
    passed += own;
  }
}

int LineNetwork::steps_for(double distance) const {
  // each: variance of the smoothing in one step, in scene units squared. n steps smooth over the distance √(n · each).
  const double apart = edge_length_ / 2, each = 2 * kStep * apart * apart;
  return static_cast<int>(std::ceil(distance * distance / each));
}

std::optional<StraightLine> LineNetwork::between(const SurfacePoint& a, const SurfacePoint& b) const {
  if (!a.vertex.is_valid()) return walk_.line(a, b, kReach * edge_length_);
  if (!b.vertex.is_valid()) {
    std::optional<StraightLine> line = walk_.line(b, a, kReach * edge_length_);
    if (!line) return line;
    std::swap(line->leaving, line->returning);
    std::reverse(line->between.begin(), line->between.end());
    for (PathPoint& point : line->between) {
      if (!point.is_vertex()) point = PathPoint::on_edge(mesh_.opposite_halfedge_handle(point.half_edge), 1 - point.t);
    }
    return line;
  }
  return StraightLine{};  // both points are fixed ends of an edge
}

std::vector<int> LineNetwork::steps_of_points(const std::vector<int>& steps) const {
  std::vector<int> of_points;
  for (const Point& point : points_) {
    int least = point.is_fixed ? 0 : steps[point.lines.front()];
    for (const std::size_t line : point.lines) least = std::min(least, steps[line]);
    of_points.push_back(least);
  }
  return of_points;
}

/// Returns the vector by which each point moves, in the plane of its face. do_pull: one flag per line. Sets has_failed
/// for each line with an obstacle between two of its points.
std::vector<Planar> LineNetwork::pulls(const std::vector<SurfacePoint>& places, const std::vector<char>& do_pull,
                                       std::vector<char>& has_failed) const {
  std::vector<Planar> sums(points_.size(), Planar(0));
  std::vector<double> nearest(points_.size(), 0);
  for (std::size_t l = 0; l < lines_.size(); ++l) {
    for (std::size_t i = 1; i < lines_[l].size() && do_pull[l] != 0; ++i) {
      const std::size_t a = lines_[l][i - 1], b = lines_[l][i];
      const std::optional<StraightLine> line = between(places[a], places[b]);
      if (!line) {
        has_failed[l] = 1;
        break;
      }
      const double length = std::abs(line->leaving);
      for (const auto& [point, vector] : {std::pair(a, line->leaving), std::pair(b, line->returning)}) {
        const bool is_junction = points_[point].lines.size() > 1;
        sums[point] += is_junction && length > 0 ? vector / length : vector;
        nearest[point] = nearest[point] == 0 ? length : std::min(nearest[point], length);
      }
    }
  }
  for (std::size_t p = 0; p < points_.size(); ++p)
    sums[p] = kStep * sums[p] * (points_[p].lines.size() > 1 ? nearest[p] : 1.0);
  return sums;
}

std::vector<std::optional<RelaxedLine>> LineNetwork::relax(const std::vector<int>& steps, const StopToken& stop) const {
  std::vector<SurfacePoint> places;
  for (const Point& point : points_) places.push_back(point.start);
  const std::vector<int> most = steps_of_points(steps);
  std::vector<char> has_failed(lines_.size(), 0), do_pull(lines_.size());
  const int count = steps.empty() ? 0 : *std::max_element(steps.begin(), steps.end());
  for (int step = 0; step < count; ++step) {
    stop.check();
    for (std::size_t l = 0; l < lines_.size(); ++l) do_pull[l] = step < steps[l] && has_failed[l] == 0;
    const std::vector<Planar> moves = pulls(places, do_pull, has_failed);
    for (std::size_t p = 0; p < points_.size(); ++p) {
      const std::vector<std::size_t>& lines = points_[p].lines;
      const bool is_stuck = std::any_of(lines.begin(), lines.end(), [&](std::size_t l) { return has_failed[l] != 0; });
      if (step < most[p] && !is_stuck) places[p] = walk_.step(places[p], moves[p]);
    }
  }
  for (std::size_t p = 0; p < points_.size(); ++p) {
    if (points_[p].lines.size() > 1 && most[p] > 0) places[p] = snapped(places[p]);
  }
  std::vector<std::optional<RelaxedLine>> relaxed(lines_.size());
  for (std::size_t l = 0; l < lines_.size(); ++l) {
    if (steps[l] > 0 && has_failed[l] == 0) relaxed[l] = along(l, places);
  }
  return relaxed;
}

/// Returns the point moved to a nearby vertex or edge. If there is none, returns the point unchanged.
SurfacePoint LineNetwork::snapped(const SurfacePoint& point) const {
  if (point.vertex.is_valid()) return point;
  const std::array<double, 3> shares = weights_at(mesh_, point.face, point.place);
  const HalfedgeHandle first = mesh_.halfedge_handle(point.face);
  const HalfedgeHandle sides[] = {first, mesh_.next_halfedge_handle(first), mesh_.prev_halfedge_handle(first)};
  for (int k = 0; k < 3; ++k) {
    if (shares[k] > 1 - 2 * kSnap) return SurfacePoint::at_vertex(mesh_.from_vertex_handle(sides[k]));
  }
  for (int k = 0; k < 3; ++k) {
    const double next = shares[(k + 1) % 3], last = shares[(k + 2) % 3];
    if (shares[k] < kSnap) return point_on_edge(mesh_, sides[(k + 1) % 3], last / (next + last));
  }
  return point;
}

std::optional<RelaxedLine> LineNetwork::along(std::size_t line, const std::vector<SurfacePoint>& places) const {
  const std::vector<std::size_t>& points = lines_[line];
  RelaxedLine relaxed{places[points.front()], places[points.back()], {}, false};
  relaxed.is_closed = is_ring_[line] != 0;
  MeshPath& path = relaxed.between;
  if (relaxed.start.vertex.is_valid()) path.push_back(PathPoint::at_vertex(relaxed.start.vertex));
  for (std::size_t i = 1; i < points.size(); ++i) {
    const SurfacePoint& to = places[points[i]];
    const std::optional<StraightLine> way = between(places[points[i - 1]], to);
    if (!way) return std::nullopt;
    for (const PathPoint& point : way->between) append(mesh_, point, path);
    if (to.vertex.is_valid()) append(mesh_, PathPoint::at_vertex(to.vertex), path);
  }
  if (relaxed.is_closed) {
    if (!close(mesh_, path)) return std::nullopt;
  } else {
    const double longest = std::max(longest_edge_at(mesh_, relaxed.start), longest_edge_at(mesh_, relaxed.end));
    if (length_of_line(mesh_, relaxed) < kShortest * longest) return std::nullopt;
  }
  if (!is_connected(mesh_, relaxed) || runs_along_barrier(line, path)) return std::nullopt;
  return relaxed;
}

}  // namespace wirewarp
