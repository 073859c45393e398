// SPDX-License-Identifier: GPL-3.0-or-later
// The lines of a cut set on the chart of a piece. They follow edges or cross triangles, and meet at their ends only.
#pragma once

#include <array>
#include <vector>

#include "cuts/feasibility/cut_mask.h"
#include "surface/charts/chart.h"
#include "warp/topology/straight_walk.h"
#include "wirewarp/cut_mesh.h"
#include "wirewarp/surface_path.h"

namespace wirewarp {

/// A straight section of a line in one face.
struct LineSection {
  FaceHandle face;
  Planar from, to;                      // places in the face: see SurfacePoint
  VertexHandle vertex_from, vertex_to;  // valid if an end is a vertex
  EdgeHandle edge;                      // valid if the section is an edge
};

/// A line. Lines whose ends have the same number meet there.
struct SurfaceLine {
  int first = 0, last = 0;
  std::vector<LineSection> sections;
};

struct SurfaceLines {
  std::vector<SurfaceLine> lines;
  std::vector<std::size_t> images;  // mirror image of each line; the line itself if it has none
  bool is_symmetric = false;        // whether each line has a mirror image
};

/// Returns the sections of a cut. image: mirror image of each vertex, or empty.
SurfaceLines lines_along(const Chart& chart, const std::vector<VertexHandle>& image, const CutMask& cut);

/// Returns the sections of a cut of a chart on the mesh of cut_mesh(), as lines on the chart before. chart: a chart of
/// the input; cut_chart: its chart on the cut mesh; image: the mirror image of each of its vertices, or empty.
SurfaceLines lines_across(const FlattenInput& input, const Chart& chart, const CutMesh& mesh, const Chart& cut_chart,
                          const std::vector<VertexHandle>& image, const CutMask& cut);

/// Returns the lines whose flag is not 0. The ends of each other line become one end.
SurfaceLines selected(const SurfaceLines& lines, const std::vector<char>& flags);

/// A point of the input: a face and the weights of its corners.
struct WeightedPoint {
  int face;
  Eigen::RowVector3d weights;
};

/// Returns the barycentric coordinates of a place in a face, from the start of its first half-edge.
std::array<double, 3> weights_at(const HalfEdgeMesh& mesh, FaceHandle face, Planar place);

/// Return a point on a chart as a point of the input.
WeightedPoint on_input(const FlattenInput& input, const Chart& chart, FaceHandle face, Planar place);
WeightedPoint on_input(const FlattenInput& input, const Chart& chart, const PathPoint& point);

SurfacePath path_through(const std::vector<WeightedPoint>& points);

/// Returns a line as a path on the input.
SurfacePath path_of(const FlattenInput& input, const Chart& chart, const SurfaceLine& line);

}  // namespace wirewarp
