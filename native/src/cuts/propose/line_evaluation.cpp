// SPDX-License-Identifier: GPL-3.0-or-later
#include "cuts/propose/line_evaluation.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "cuts/propose/cut_faces.h"
#include "cuts/propose/surface_lines.h"
#include "surface/mesh/geometry.h"
#include "wirewarp/cut_mesh.h"

namespace wirewarp {
namespace {

/// Radius within which the strain shows whether a tip puckers, as a share of √area of the piece. On a front of 30 by 40
/// cm, it is about 10 mm.
constexpr double kAroundTip = 0.03;

std::optional<double> mean_strain_around(const FlatPiece& piece, int tip, double radius) {
  const HalfEdgeMesh& mesh = piece.chart.mesh;
  const std::vector<int>& sources = piece.chart.source_vertex;
  const auto found = std::find(sources.begin(), sources.end(), tip);
  if (found == sources.end()) return std::nullopt;
  const VertexHandle v(static_cast<int>(found - sources.begin()));
  double area = 0, strained = 0;
  for (const FaceHandle f : mesh.faces()) {
    HalfEdgeMesh::Point center(0, 0, 0);
    bool has_tip = false;
    for (const VertexHandle corner : mesh.fv_range(f)) {
      center += mesh.point(corner) / 3.0;
      has_tip = has_tip || corner == v;
    }
    if (!has_tip && (center - mesh.point(v)).norm() > radius) continue;
    const double own = face_area(mesh, f);
    area += own;
    strained += own * piece.face_strain[f.idx()];
  }
  return strained / area;
}

/// Returns the last vertex of each path, or an empty list if paths meet.
std::vector<int> tips_of(const CutMesh& cut) {
  std::map<int, int> count;
  for (const VertexPair& edge : cut.edges) {
    for (const int v : edge) ++count[v];
  }
  std::vector<int> tips, ends;
  for (std::size_t i = 0; i < cut.edges.size(); ++i) {
    const std::vector<int>& paths = cut.sources.edge_paths;
    if (i == 0 || paths[i - 1] != paths[i]) ends.push_back(cut.edges[i][0]);
    if (i + 1 < cut.edges.size() && paths[i + 1] == paths[i]) continue;
    tips.push_back(cut.edges[i][1]);
    ends.push_back(tips.back());
  }
  const bool do_meet = std::any_of(count.begin(), count.end(), [](const auto& each) { return each.second > 2; }) ||
                       std::any_of(ends.begin(), ends.end(), [&](int end) { return count[end] > 1; });
  return do_meet ? std::vector<int>{} : tips;
}

FlattenInput with_mesh_of(const FlattenInput& input, const CutMesh& cut) {
  return {cut.vertices, cut.faces, input.seams, input.wires, input.eases};
}

/// Returns the piece before the cut, with the vertices and faces of the cut mesh, for with_cut(). Its energy and strain
/// are those on the original mesh.
FlatPiece on_cut_mesh(const FlatPiece& piece, const SurfaceToCut& surface, const CutMesh& cut, const StopToken& stop) {
  const std::vector<int>& faces_before = piece.chart.source_face;
  std::vector<int> faces;
  for (std::size_t f = 0; f < cut.sources.faces.size(); ++f) {
    if (std::binary_search(faces_before.begin(), faces_before.end(), cut.sources.faces[f])) {
      faces.push_back(static_cast<int>(f));
    }
  }
  Chart chart = std::move(cut_faces(surface.middle(), surface.fans(), faces, piece.outline, stop).charts.front());
  PartMap edges(chart);
  std::vector<VertexPair> outline = outline_of(chart);
  return {std::move(chart), std::move(edges), std::move(outline), piece.error, piece.energy, piece.area, piece.strain};
}

}  // namespace

SurfacePath on_input(const FlattenInput& input, const Chart& chart, const MeshPath& path) {
  std::vector<WeightedPoint> points;
  for (const PathPoint& point : path) points.push_back(on_input(input, chart, point));
  return path_through(points);
}

std::vector<SurfacePath> paths_along(const Triangles& faces, const std::vector<VertexPair>& edges) {
  std::map<int, std::pair<int, int>> corner_at;  // per vertex of the lines: a face, and the vertex's index in the face
  for (const VertexPair& edge : edges) {
    for (const int v : edge) corner_at[v] = {-1, 0};
  }
  for (int f = 0; f < static_cast<int>(faces.rows()); ++f) {
    for (int k = 0; k < 3; ++k) {
      const auto found = corner_at.find(faces(f, k));
      if (found != corner_at.end()) found->second = {f, k};
    }
  }
  std::vector<std::vector<int>> lines;
  for (const auto& [from, to] : edges) {
    if (lines.empty() || lines.back().back() != from) lines.push_back({from});
    lines.back().push_back(to);
  }
  std::vector<SurfacePath> paths;
  for (const std::vector<int>& line : lines) {
    std::vector<WeightedPoint> points;
    for (const int v : line) points.push_back({corner_at[v].first, Eigen::RowVector3d::Unit(corner_at[v].second)});
    paths.push_back(path_through(points));
  }
  return paths;
}

CutSurface::CutSurface(const FlatPieces& pieces, std::size_t piece, const ExactEvaluation& exact, const CutMesh& cut)
    : cut_(cut),
      piece_(piece),
      has_new_vertices_(cut.vertices.rows() > exact.surface().given().vertices.rows()),
      input_(with_mesh_of(exact.surface().given(), cut)),
      surface_(input_, exact.options()),
      exact_(surface_, exact.options(), exact.stop()),
      before_(pieces) {
  before_[piece] = std::make_shared<FlatPiece>(on_cut_mesh(*pieces[piece], surface_, cut, exact.stop()));
  after_ = exact_.with_cut(before_, cut.edges);
}

std::vector<VertexPair> CutSurface::edges() const { return has_new_vertices_ ? std::vector<VertexPair>{} : cut_.edges; }

double CutSurface::length() const {
  const Positions3& places = surface_.middle().vertices;
  double length = 0;
  for (const auto& [a, b] : cut_.edges) length += (places.row(a) - places.row(b)).norm();
  return length;
}

DartProposal with_lines(DartProposal set, std::vector<SurfacePath> paths, const CutSurface& surface,
                        const PieceFigures& figures) {
  set.edges = surface.edges();
  set.paths = std::move(paths);
  set.length = surface.length();
  set.num_pieces = figures.num_pieces;
  set.energy = figures.energy;
  set.strain = figures.strain;
  return set;
}

std::optional<LineFigures> figures_with_lines(const FlatPieces& pieces, std::size_t piece,
                                              const std::vector<SurfacePath>& lines, const ExactEvaluation& exact) {
  const FlattenInput& given = exact.surface().given();
  const CutMesh cut = cut_mesh(given.vertices, given.faces, lines);
  const std::vector<int> tips = tips_of(cut);
  if (tips.size() != lines.size()) return std::nullopt;
  const CutSurface surface(pieces, piece, exact, cut);
  const FlatPieces &before = surface.before(), &after = surface.after();
  LineFigures result{figures_of(after, surface.chart()), 0, surface.edges()};
  if (result.figures.error || spoils_others(before, after, surface.chart())) return std::nullopt;
  const double radius = kAroundTip * std::sqrt(result.figures.area);
  for (const int tip : tips) {
    for (const std::shared_ptr<const FlatPiece>& part : after) {
      const std::optional<double> strain = mean_strain_around(*part, tip, radius);
      if (strain) result.tip_strain = std::max(result.tip_strain, *strain);
    }
  }
  return result;
}

}  // namespace wirewarp
