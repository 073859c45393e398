// SPDX-License-Identifier: GPL-3.0-or-later
// Smooths lines on a surface. The lines shorten like elastic threads, for a limited number of steps.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "base/stop_token.h"
#include "cuts/propose/surface_lines.h"

namespace wirewarp {

struct RelaxedLine {
  SurfacePoint start, end;  // not used if the line is closed
  MeshPath between;         // vertices of the line and its crossings with edges; a closed line repeats its first point
  bool is_closed = false;
};

/// Lines that meet at their ends and do not cross barriers. Points on barriers are fixed, and so are ends that no other
/// line meets. Junctions move.
class LineNetwork {
 public:
  /// barriers: one flag per edge. The mesh and the barriers must outlive the network.
  LineNetwork(const HalfEdgeMesh& mesh, const std::vector<SurfaceLine>& lines, const std::vector<char>& barriers);

  /// Moves the points of each line by its number of steps, and junctions by the fewest steps of their lines. Returns
  /// nullopt for each line that has no steps, comes too close to a barrier, or becomes too short. Throws Stopped.
  std::vector<std::optional<RelaxedLine>> relax(const std::vector<int>& steps, const StopToken& stop) const;

  /// Returns the mean length of the edges that lines follow, in scene units. If lines cross triangles, returns the
  /// typical edge length of the mesh.
  double mean_edge() const { return edge_length_; }

  /// Returns how many steps are needed to smooth lines over about this distance, in scene units.
  int steps_for(double distance) const;

 private:
  struct Point {
    SurfacePoint start;
    std::vector<std::size_t> lines;  // lines that contain this point
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
  std::map<int, std::size_t> junctions_;         // index into points_ for each end: see SurfaceLine::first and last
  std::vector<std::vector<std::size_t>> lines_;  // points of each line; a closed line repeats its first point
  std::vector<char> is_ring_;                    // per line: whether it is closed
  std::vector<std::vector<EdgeHandle>> edges_;   // per line: the edges that it follows, in increasing order
};

}  // namespace wirewarp
