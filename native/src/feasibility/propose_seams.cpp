// SPDX-License-Identifier: GPL-3.0-or-later
#include "feasibility/propose_seams.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "arap/free_boundary_arap.h"
#include "charts/chart_faults.h"
#include "factorization_failed.h"
#include "feasibility/cut_apart.h"
#include "feasibility/cut_to_disk.h"
#include "feasibility/folded_faces.h"
#include "feasibility/halve.h"
#include "feasibility/isoperimetric.h"
#include "mesh/geometry.h"
#include "mesh/shortest_paths.h"

namespace wirewarp {
namespace {

constexpr int kMostDepth = 3;  // cuts of pieces of pieces: eight of them, as many as a garment has
constexpr int kMostTrials =
    3;  // in full, of the cuts of one chart: with 2 garments fall into more pieces, 5 are no better

/// What distortion costs, in cut length over the square root of the area: a cushion is cut around its edge (2.8,
/// distortion 0.02) and not open along one line (1.2, distortion 0.3), a skirt open along one (0.7, 0.014) and not
/// into two (1.3, 0.01). On 43 garments, shoes, cushions and toys all lie flat in the end whatever it is; with 3, 10,
/// 30, 100 the cuts sum up to 86, 97, 100, 103 and the distortions to 3.5, 0.9, 0.6, 0.5.
constexpr double kPriceOfDistortion = 10;

/// How a chart lies when no length is held.
struct FreeLook {
  double covered = 0;     // area of faces that are turned over or overlap others, scene units squared
  double distortion = 0;  // E of Eq. (4), scene units squared
};

FreeLook look_at_whole(const Chart& chart) {
  const double area = surface_area(chart.mesh);
  const FreeLook nothing{area, area};
  if (chart.error || is_outline_too_short(chart)) return nothing;
  try {
    const FreeBoundaryArap free = free_boundary_arap(chart, kFreeSteps);
    FreeLook look{0, free.energy};
    for (const int f : find_folded_faces(chart.mesh, free.uv)) look.covered += face_area(chart.mesh, FaceHandle(f));
    return look;
  } catch (const FactorizationFailed&) {
    return nothing;
  }
}

/// A cut, and what comes of it.
struct Division {
  CutMask cut;
  std::vector<Chart> pieces;
  std::vector<FreeLook> looks;  // of the pieces
  double price = 0;             // the smaller, the better
  double covered = 0;           // of the area
};

void unite(CutMask& cut, const CutMask& other) {
  for (std::size_t e = 0; e < cut.size(); ++e) cut[e] = cut[e] || other[e];
}

/// A cut of a piece as one of the chart that it is a piece of.
CutMask cut_of_whole(const Chart& chart, const Chart& piece, const CutMask& cut) {
  CutMask result(chart.mesh.n_edges(), 0);
  for (const EdgeHandle e : piece.mesh.edges()) {
    if (!cut[e.idx()]) continue;
    const auto [from, to] = source_edge(piece, piece.mesh.halfedge_handle(e, 0));
    const HalfedgeHandle h = chart.mesh.find_halfedge(VertexHandle(from), VertexHandle(to));
    result[chart.mesh.edge_handle(h).idx()] = 1;
  }
  return result;
}

bool is_empty(const CutMask& cut) { return std::find(cut.begin(), cut.end(), 1) == cut.end(); }

/// From the boundary, or on a closed surface from one far end, to the vertex farthest from there.
CutMask slit_to_far_end(const HalfEdgeMesh& mesh) {
  std::vector<VertexHandle> starts = boundary_vertices(mesh);
  const bool is_closed = starts.empty();
  if (is_closed) starts.push_back(farthest_vertex(shortest_paths(mesh, {VertexHandle(0)})));
  const ShortestPaths paths = shortest_paths(mesh, starts);
  const std::vector<HalfedgeHandle> path = path_back(mesh, paths, farthest_vertex(paths));
  CutMask cut(mesh.n_edges(), 0);
  // Both sides of a single edge inside a closed surface would be one loop of two edges between the same vertices.
  if (is_closed && path.size() == 1) return cut;
  for (const HalfedgeHandle h : path) cut[mesh.edge_handle(h).idx()] = 1;
  return cut;
}

class SeamSearch {
 public:
  explicit SeamSearch(const SeamTrials& trials) : trials_(trials) {}

  CutMask mend(const Chart& chart, int depth) const;

 private:
  std::vector<Division> divisions(const Chart& chart) const;
  Division divide(const Chart& chart, CutMask cut) const;
  std::vector<std::size_t> failing_pieces(const Division& division) const;

  const SeamTrials& trials_;
};

/// Opens the pieces that do not lie flat as they are.
Division SeamSearch::divide(const Chart& chart, CutMask cut) const {
  Division division{std::move(cut), {}, {}, 0, 0};
  bool opens_more = false;
  const auto take = [&](const Chart& piece) {
    division.looks.push_back(look_at_whole(piece));
    return division.looks.back().covered > 0;
  };
  division.pieces = cut_apart(chart, division.cut);
  for (const Chart& piece : division.pieces) {
    if (!take(piece) || piece.mesh.n_faces() == 0) continue;
    const CutMask opening = cut_to_disk(piece.mesh);
    if (is_empty(opening)) continue;
    unite(division.cut, cut_of_whole(chart, piece, opening));
    opens_more = true;
  }
  if (opens_more) {
    division.looks.clear();
    division.pieces = cut_apart(chart, division.cut);
    for (const Chart& piece : division.pieces) take(piece);
  }
  double distortion = 0;
  for (const FreeLook& look : division.looks) {
    division.covered += look.covered;
    distortion += look.distortion;
  }
  const double area = surface_area(chart.mesh);
  division.covered /= area;
  division.price = length_of_cut(chart.mesh, division.cut) / std::sqrt(area) + kPriceOfDistortion * distortion / area;
  return division;
}

/// The best first.
std::vector<Division> SeamSearch::divisions(const Chart& chart) const {
  std::vector<CutMask> cuts = halving_cuts(chart.mesh);
  const bool is_disk = chart.boundary_loops.size() == 1 && count_handles(chart) == 0;
  cuts.push_back(is_disk || chart.boundary_loops.empty() ? slit_to_far_end(chart.mesh) : cut_to_disk(chart.mesh));
  if (chart.boundary_loops.empty()) cuts.push_back(cut_to_disk(chart.mesh));
  std::vector<Division> result;
  for (CutMask& cut : cuts) {
    if (!trials_.go_on()) return {};
    if (!is_empty(cut)) result.push_back(divide(chart, std::move(cut)));
  }
  std::stable_sort(result.begin(), result.end(), [](const Division& a, const Division& b) {
    return std::make_pair(a.covered, a.price) < std::make_pair(b.covered, b.price);
  });
  return result;
}

std::vector<std::size_t> SeamSearch::failing_pieces(const Division& division) const {
  std::vector<std::size_t> failing;
  for (std::size_t i = 0; i < division.pieces.size(); ++i) {
    if (division.looks[i].covered > 0 || !trials_.lies_flat(division.pieces[i])) failing.push_back(i);
  }
  return failing;
}

CutMask SeamSearch::mend(const Chart& chart, int depth) const {
  const std::vector<Division> tried = divisions(chart);
  if (tried.empty()) return CutMask(chart.mesh.n_edges(), 0);
  const Division* best = nullptr;
  std::vector<std::size_t> failing;
  double failing_area = 0;
  for (std::size_t i = 0; i < tried.size() && i < kMostTrials && (!best || !failing.empty()); ++i) {
    if (!trials_.go_on()) return CutMask(chart.mesh.n_edges(), 0);
    std::vector<std::size_t> failing_here = failing_pieces(tried[i]);
    double area = 0;
    for (const std::size_t p : failing_here) area += surface_area(tried[i].pieces[p].mesh);
    if (best && area >= failing_area) continue;
    best = &tried[i];
    failing = std::move(failing_here);
    failing_area = area;
  }
  CutMask cut = best->cut;
  for (const std::size_t p : failing) {
    const Chart& piece = best->pieces[p];
    if (depth == 0 || piece.mesh.n_faces() < 2) continue;
    unite(cut, cut_of_whole(chart, piece, mend(piece, depth - 1)));
  }
  return cut;
}

}  // namespace

std::vector<VertexPair> propose_seams(const Chart& chart, const SeamTrials& trials) {
  const CutMask cut = SeamSearch(trials).mend(chart, kMostDepth);
  std::vector<VertexPair> seams;
  if (!trials.go_on()) return seams;
  for (const EdgeHandle e : chart.mesh.edges()) {
    if (cut[e.idx()]) seams.push_back(source_edge(chart, chart.mesh.halfedge_handle(e, 0)));
  }
  return seams;
}

}  // namespace wirewarp
