// SPDX-License-Identifier: GPL-3.0-or-later
// Points on a mesh, straight steps from them, and straight lines between them.
#pragma once

#include <optional>
#include <vector>

#include "warp/topology/surface_path.h"

namespace wirewarp {

/// A vertex, or a point in a face or on its border.
struct SurfacePoint {
  VertexHandle vertex;  // valid if the point is a vertex
  FaceHandle face;      // valid if the point is not a vertex
  Planar place;         // in the plane of the face's first half-edge: see apex_over()

  static SurfacePoint at_vertex(VertexHandle v) { return {v, FaceHandle(), Planar(0)}; }
  static SurfacePoint in_face(FaceHandle f, Planar place) { return {VertexHandle(), f, place}; }
};

/// The straight line to another point. If a vertex is in the way, the line consists of two straight lines.
struct StraightLine {
  Planar leaving;    // vector to the end, in the plane of the start
  Planar returning;  // vector to the start, in the plane of the end
  MeshPath between;  // crossed edges, and the vertex in the way
};

/// Walks straight on a mesh. In the plane of a vertex, its first half-edge is along the real axis. Angles at the vertex
/// are scaled to a total of 2 pi.
class StraightWalk {
 public:
  /// barriers: one flag per edge, whether steps and lines may not cross the edge. Both arguments must outlive the walk.
  StraightWalk(const HalfEdgeMesh& mesh, const std::vector<char>& barriers) : mesh_(mesh), barriers_(barriers) {}

  /// Returns the point where a straight step ends; the start if the step meets a barrier or the outline.
  SurfacePoint step(const SurfacePoint& from, Planar vector) const;

  /// Returns the line from a point in a face to another point; none if every line is longer than `longest` or crosses a
  /// barrier.
  std::optional<StraightLine> line(const SurfacePoint& from, const SurfacePoint& to, double longest) const;

 private:
  const HalfEdgeMesh& mesh_;
  const std::vector<char>& barriers_;
};

inline std::vector<FaceHandle> faces_at(const HalfEdgeMesh& mesh, const SurfacePoint& point) {
  return point.vertex.is_valid() ? faces_at(mesh, point.vertex) : std::vector<FaceHandle>{point.face};
}

HalfEdgeMesh::Point position(const HalfEdgeMesh& mesh, const SurfacePoint& point);

/// Returns the point on an edge at this share of its length from the start of h.
SurfacePoint point_on_edge(const HalfEdgeMesh& mesh, HalfedgeHandle h, double share);

}  // namespace wirewarp
