// SPDX-License-Identifier: GPL-3.0-or-later
#include "cuts/propose/surface_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "cuts/propose/cut_chains.h"
#include "cuts/propose/mirror_image.h"
#include "surface/mesh/geometry.h"

namespace wirewarp {
namespace {

/// Smaller weights of a corner are rounding errors.
constexpr double kRoundedWeight = 1e-9;

/// Returns the corners of a face, starting at its first half-edge, with their places in the plane of the face.
std::array<std::pair<VertexHandle, Planar>, 3> corners_of(const HalfEdgeMesh& mesh, FaceHandle f) {
  const HalfedgeHandle first = mesh.halfedge_handle(f);
  return {{{mesh.from_vertex_handle(first), Planar(0)},
           {mesh.to_vertex_handle(first), Planar(edge_length(mesh, first))},
           {mesh.to_vertex_handle(mesh.next_halfedge_handle(first)), apex_over(mesh, first)}}};
}

/// Returns the index (0 to 2) of a vertex in a face of the input.
int corner_of(const Triangles& faces, int face, int vertex) {
  int corner = 0;
  while (faces(face, corner) != vertex) ++corner;
  return corner;
}

/// Sets `images` and `is_symmetric` for lines along these chains.
void find_images(const Chart& chart, const std::vector<VertexHandle>& image, const std::vector<HalfEdgeChain>& chains,
                 SurfaceLines& lines) {
  const std::size_t none = chains.size();
  std::vector<std::size_t> line_at(chart.mesh.n_edges(), none);
  const auto line_of = [&](HalfedgeHandle h) -> std::size_t& { return line_at[chart.mesh.edge_handle(h).idx()]; };
  for (std::size_t i = 0; i < chains.size(); ++i) {
    for (const HalfedgeHandle h : chains[i]) line_of(h) = i;
  }
  lines.is_symmetric = !image.empty();
  for (std::size_t i = 0; i < chains.size(); ++i) {
    const HalfEdgeChain other = image.empty() ? HalfEdgeChain{} : mirrored(chart, image, chains[i]);
    const std::size_t found = other.empty() ? none : line_of(other.front());
    const bool is_image =
        found != none && chains[found].size() == other.size() &&
        std::all_of(other.begin(), other.end(), [&](HalfedgeHandle h) { return line_of(h) == found; });
    lines.images.push_back(is_image ? found : i);
    lines.is_symmetric = lines.is_symmetric && is_image;
  }
}

template <typename Section>
SurfaceLines lines_of(const Chart& chart, const std::vector<VertexHandle>& image, const CutMask& cut,
                      const Section& section) {
  SurfaceLines result;
  const std::vector<HalfEdgeChain> chains = sections_of(chart.mesh, cut);
  for (const HalfEdgeChain& chain : chains) {
    SurfaceLine& line = result.lines.emplace_back();
    line.first = chart.mesh.from_vertex_handle(chain.front()).idx();
    line.last = chart.mesh.to_vertex_handle(chain.back()).idx();
    for (const HalfedgeHandle h : chain) line.sections.push_back(section(h));
  }
  find_images(chart, image, chains, result);
  return result;
}

HalfedgeHandle side_with_face(const HalfEdgeMesh& mesh, HalfedgeHandle h) {
  return mesh.is_boundary(h) ? mesh.opposite_halfedge_handle(h) : h;
}

}  // namespace

SurfaceLines lines_along(const Chart& chart, const std::vector<VertexHandle>& image, const CutMask& cut) {
  const HalfEdgeMesh& mesh = chart.mesh;
  return lines_of(chart, image, cut, [&](HalfedgeHandle h) {
    LineSection section;
    section.face = mesh.face_handle(side_with_face(mesh, h));
    section.vertex_from = mesh.from_vertex_handle(h);
    section.vertex_to = mesh.to_vertex_handle(h);
    section.edge = mesh.edge_handle(h);
    for (const auto& [v, place] : corners_of(mesh, section.face)) {
      if (v == section.vertex_from) section.from = place;
      if (v == section.vertex_to) section.to = place;
    }
    return section;
  });
}

SurfaceLines lines_across(const FlattenInput& input, const Chart& chart, const CutMesh& mesh, const Chart& cut_chart,
                          const std::vector<VertexHandle>& image, const CutMask& cut) {
  std::vector<int> face_of(static_cast<std::size_t>(input.faces.rows()), -1);  // chart face of each input face
  for (std::size_t f = 0; f < chart.source_face.size(); ++f)
    face_of[static_cast<std::size_t>(chart.source_face[f])] = static_cast<int>(f);
  return lines_of(cut_chart, image, cut, [&](HalfedgeHandle h) {
    const FaceHandle small = cut_chart.mesh.face_handle(side_with_face(cut_chart.mesh, h));
    const int cut_face = cut_chart.source_face[small.idx()];
    const int face = mesh.sources.faces[static_cast<std::size_t>(cut_face)];
    LineSection section;
    section.face = FaceHandle(face_of[static_cast<std::size_t>(face)]);
    const auto corners = corners_of(chart.mesh, section.face);
    const auto find = [&](VertexHandle v, Planar& place, VertexHandle& vertex) {
      const int source = cut_chart.source_vertex[v.idx()], corner = corner_of(mesh.faces, cut_face, source);
      for (const auto& [own, at] : corners) {
        const int own_source = chart.source_vertex[own.idx()];
        place += mesh.sources.corner_weights(cut_face, 3 * corner + corner_of(input.faces, face, own_source)) * at;
        if (source == own_source) vertex = own;
      }
    };
    find(cut_chart.mesh.from_vertex_handle(h), section.from, section.vertex_from);
    find(cut_chart.mesh.to_vertex_handle(h), section.to, section.vertex_to);
    if (section.vertex_from.is_valid() && section.vertex_to.is_valid())
      section.edge = chart.mesh.edge_handle(chart.mesh.find_halfedge(section.vertex_from, section.vertex_to));
    return section;
  });
}

SurfaceLines selected(const SurfaceLines& lines, const std::vector<char>& flags) {
  std::map<int, int> renamed;  // for each end that was merged into another end: this other end
  const auto name_of = [&](int end) {
    for (auto found = renamed.find(end); found != renamed.end(); found = renamed.find(end)) end = found->second;
    return end;
  };
  std::vector<std::size_t> new_index(lines.lines.size());
  SurfaceLines result;
  for (std::size_t i = 0; i < lines.lines.size(); ++i) {
    new_index[i] = result.lines.size();
    const SurfaceLine& line = lines.lines[i];
    const int first = name_of(line.first), last = name_of(line.last);
    if (flags[i] != 0) {
      result.lines.push_back(line);
    } else if (first != last) {
      renamed[last] = first;
    }
  }
  for (SurfaceLine& line : result.lines) {
    line.first = name_of(line.first);
    line.last = name_of(line.last);
  }
  result.is_symmetric = lines.is_symmetric;
  for (std::size_t i = 0; i < lines.lines.size(); ++i) {
    if (flags[i] == 0) continue;
    const bool has_image = flags[lines.images[i]] != 0;
    result.images.push_back(new_index[has_image ? lines.images[i] : i]);
    result.is_symmetric = result.is_symmetric && has_image;
  }
  return result;
}

std::array<double, 3> weights_at(const HalfEdgeMesh& mesh, FaceHandle face, Planar place) {
  const HalfedgeHandle first = mesh.halfedge_handle(face);
  const Planar apex = apex_over(mesh, first);
  const double third = place.imag() / apex.imag();
  const double second = (place.real() - third * apex.real()) / edge_length(mesh, first);
  return {1 - second - third, second, third};
}

WeightedPoint on_input(const FlattenInput& input, const Chart& chart, FaceHandle face, Planar place) {
  WeightedPoint point{chart.source_face[face.idx()], Eigen::RowVector3d::Zero()};
  HalfedgeHandle h = chart.mesh.halfedge_handle(face);
  for (const double weight : weights_at(chart.mesh, face, place)) {
    const int source = chart.source_vertex[chart.mesh.from_vertex_handle(h).idx()];
    point.weights[corner_of(input.faces, point.face, source)] = weight < kRoundedWeight ? 0 : weight;
    h = chart.mesh.next_halfedge_handle(h);
  }
  point.weights /= point.weights.sum();
  return point;
}

WeightedPoint on_input(const FlattenInput& input, const Chart& chart, const PathPoint& point) {
  const HalfEdgeMesh& mesh = chart.mesh;
  const FaceHandle face = point.is_vertex() ? *mesh.cvf_begin(point.vertex) : mesh.face_handle(point.half_edge);
  WeightedPoint result{chart.source_face[face.idx()], Eigen::RowVector3d::Zero()};
  const auto put = [&](VertexHandle v, double weight) {
    result.weights[corner_of(input.faces, result.face, chart.source_vertex[v.idx()])] = weight;
  };
  if (point.is_vertex()) {
    put(point.vertex, 1);
  } else {
    put(mesh.from_vertex_handle(point.half_edge), 1 - point.t);
    put(mesh.to_vertex_handle(point.half_edge), point.t);
  }
  return result;
}

SurfacePath path_through(const std::vector<WeightedPoint>& points) {
  SurfacePath path{{}, Positions3(static_cast<Eigen::Index>(points.size()), 3)};
  for (const WeightedPoint& point : points) {
    path.coordinates.row(static_cast<Eigen::Index>(path.faces.size())) = point.weights;
    path.faces.push_back(point.face);
  }
  return path;
}

std::vector<SurfacePath> paths_of(const FlattenInput& input, const Chart& chart, const SurfaceLines& lines) {
  std::vector<SurfacePath> paths;
  for (const auto& [first, last, sections] : lines.lines) {
    std::vector<WeightedPoint> points;
    for (const LineSection& section : sections) points.push_back(on_input(input, chart, section.face, section.from));
    points.push_back(on_input(input, chart, sections.back().face, sections.back().to));
    paths.push_back(path_through(points));
  }
  return paths;
}

}  // namespace wirewarp
