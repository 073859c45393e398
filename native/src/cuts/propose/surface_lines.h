// SPDX-License-Identifier: GPL-3.0-or-later
// Describes the lines of a cut set on the chart of a piece. Lines follow edges or cross triangles, and meet only at
// their ends.
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
  Planar from, to;                      // ends, as places in the face: see SurfacePoint
  VertexHandle vertex_from, vertex_to;  // vertices at these ends; invalid for an end that is not a vertex
  EdgeHandle edge;                      // valid if the section is an edge
};

struct SurfaceLine {
  int first = 0, last = 0;  // numbers of the ends; lines meet at ends with the same number
  std::vector<LineSection> sections;
};

struct SurfaceLines {
  std::vector<SurfaceLine> lines;
  std::vector<std::size_t> images;  // index of each line's mirror image; its own index if it has none
  bool is_symmetric = false;        // whether each line has a mirror image
};

/// Returns the sections of a cut as lines along edges. image: mirror image of each vertex, or empty.
SurfaceLines lines_along(const Chart& chart, const std::vector<VertexHandle>& image, const CutMask& cut);

/// Returns the sections of a cut of `cut_chart` as lines on `chart`, a chart of the input.
/// - mesh: the result of cut_mesh() for the input
/// - cut_chart: the same surface on `mesh`
/// - image: mirror image of each vertex of `cut_chart`, or empty
SurfaceLines lines_across(const FlattenInput& input, const Chart& chart, const CutMesh& mesh, const Chart& cut_chart,
                          const std::vector<VertexHandle>& image, const CutMask& cut);

/// Returns the lines whose flag is not 0. The lines at both ends of a dropped line then meet.
SurfaceLines selected(const SurfaceLines& lines, const std::vector<char>& flags);

/// A point of the input: a face and the weights of its corners.
struct WeightedPoint {
  int face;
  Eigen::RowVector3d weights;
};

/// Returns the barycentric coordinates of a place in a face. The first corner is the start of the face's first
/// half-edge.
std::array<double, 3> weights_at(const HalfEdgeMesh& mesh, FaceHandle face, Planar place);

/// Returns a point on a chart as a point of the input.
WeightedPoint on_input(const FlattenInput& input, const Chart& chart, FaceHandle face, Planar place);
WeightedPoint on_input(const FlattenInput& input, const Chart& chart, const PathPoint& point);

SurfacePath path_through(const std::vector<WeightedPoint>& points);

std::vector<SurfacePath> paths_of(const FlattenInput& input, const Chart& chart, const SurfaceLines& lines);

}  // namespace wirewarp
