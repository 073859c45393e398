// SPDX-License-Identifier: GPL-3.0-or-later
// Makes lines along edges smooth: they shorten like elastic threads on the surface, for a limited time.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "base/stop_token.h"
#include "cuts/propose/surface_lines.h"

namespace wirewarp {

/// A line between two points, or a closed one.
struct RelaxedLine {
  SurfacePoint start, end;  // not used if the line is closed
  MeshPath between;         // vertices of the line and its crossings with edges; a closed line repeats the first one
  bool is_closed = false;
};

/// Lines that meet at their ends. They do not cross barriers. Points on a barrier are fixed, as are ends where no other
/// line continues. Junctions move.
class LineNetwork {
 public:
  /// barriers: one flag per edge. The mesh and the barriers must outlive the network.
  LineNetwork(const HalfEdgeMesh& mesh, const std::vector<SurfaceLine>& lines, const std::vector<char>& barriers);

  /// Moves the points of each line a number of times; a junction moves as often as the line that moves least. Returns
  /// nothing for a line that does not move, or that came too close to a barrier. Throws Stopped.
  std::vector<std::optional<RelaxedLine>> relax(const std::vector<int>& steps, const StopToken& stop) const;

  /// Returns the mean length of the edges that lines follow, scene units; the typical one of the mesh if lines cross
  /// triangles.
  double mean_edge() const { return edge_length_; }

  /// Returns the number of moves of each point that smooths lines over about this distance.
  int steps_for(double distance) const;

 private:
  struct Point {
    SurfacePoint start;
    std::vector<std::size_t> lines;  // lines through this point or ending there
    bool is_fixed = false;
  };

  void add_line(const SurfaceLine& line, bool is_ring);
  void add_points(const SurfaceLine& line, std::size_t begin, std::size_t end, std::vector<std::size_t>& points);
  bool touches_barrier(VertexHandle v) const;
  bool runs_along_barrier(std::size_t line, const MeshPath& path) const;
  std::optional<StraightLine> between(const SurfacePoint& a, const SurfacePoint& b) const;
  std::vector<int> steps_of_points(const std::vector<int>& steps) const;
  std::vector<Planar> pulls(const std::vector<SurfacePoint>& places, const std::vector<char>& do_pull,
                            std::vector<char>& has_failed) const;
  SurfacePoint snapped(const SurfacePoint& point) const;
  std::optional<RelaxedLine> along(std::size_t line, const std::vector<SurfacePoint>& places) const;

  const HalfEdgeMesh& mesh_;
  const std::vector<char>& barriers_;
  const StraightWalk walk_;
  double edge_length_;  // see mean_edge()
  std::vector<Point> points_;
  std::map<int, std::size_t> junctions_;         // point at each end of a line
  std::vector<std::vector<std::size_t>> lines_;  // points of each line; the first one again at the end of a closed one
  std::vector<char> is_ring_;                    // of each line
  std::vector<std::vector<EdgeHandle>> edges_;   // edges that each line follows, in increasing order
};

}  // namespace wirewarp
