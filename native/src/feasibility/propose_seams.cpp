// SPDX-License-Identifier: GPL-3.0-or-later
#include "feasibility/propose_seams.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "arap/free_boundary_arap.h"
#include "charts/chart_faults.h"
#include "factorization_failed.h"
#include "feasibility/cut_apart.h"
#include "feasibility/cut_to_disk.h"
#include "feasibility/folded_faces.h"
#include "feasibility/halve.h"
#include "feasibility/isoperimetric.h"
#include "feasibility/mirrored_cuts.h"
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

/// Shares of the area and prices that differ by less are the same: which is first depends on no rounding.
constexpr double kSamePrice = 1e-6;

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

bool is_empty(const CutMask& cut) { return std::find(cut.begin(), cut.end(), 1) == cut.end(); }

/// From the boundary, or on a closed surface from one far end, to the vertex farthest from there.
CutMask slit_to_far_end(const HalfEdgeMesh& mesh, const CutMask& barred) {
  std::vector<VertexHandle> starts = boundary_vertices(mesh);
  const bool is_closed = starts.empty();
  if (is_closed) starts.push_back(farthest_vertex(shortest_paths(mesh, {VertexHandle(0)}, around(mesh, barred))));
  const ShortestPaths paths = shortest_paths(mesh, starts, around(mesh, barred));
  const std::vector<HalfedgeHandle> path = path_back(mesh, paths, farthest_vertex(paths));
  CutMask cut(mesh.n_edges(), 0);
  // Both sides of a single edge inside a closed surface would be one loop of two edges between the same vertices.
  if (is_closed && path.size() == 1) return cut;
  for (const HalfedgeHandle h : path) cut[mesh.edge_handle(h).idx()] = 1;
  return cut;
}

/// Cuts, of pieces too, are masks of the whole chart's edges, and pieces have their sources there.
class SeamSearch {
 public:
  SeamSearch(const Chart& whole, const SeamTrials& trials, const SeamPlaces& places)
      : whole_(whole), trials_(trials), places_(places), mirrored_(whole, places.image) {}

  CutMask mend(const Chart& piece, int depth) const;

 private:
  std::vector<CutMask> cuts_through(const Chart& piece) const;
  std::vector<Division> divisions(const Chart& piece) const;
  Division divide(const Chart& piece, CutMask cut) const;
  std::vector<Chart> pieces_of(const Chart& piece, const CutMask& cut) const;
  std::vector<std::size_t> failing_pieces(const Division& division) const;
  EdgeHandle edge_of_whole(const Chart& piece, EdgeHandle e) const;
  CutMask on_whole(const Chart& piece, const CutMask& cut) const;
  CutMask on_piece(const Chart& piece, const CutMask& cut) const;

  const Chart& whole_;
  const SeamTrials& trials_;
  const SeamPlaces& places_;
  const MirroredCuts mirrored_;
};

EdgeHandle SeamSearch::edge_of_whole(const Chart& piece, EdgeHandle e) const {
  const auto [from, to] = source_edge(piece, piece.mesh.halfedge_handle(e, 0));
  return whole_.mesh.edge_handle(whole_.mesh.find_halfedge(VertexHandle(from), VertexHandle(to)));
}

CutMask SeamSearch::on_whole(const Chart& piece, const CutMask& cut) const {
  CutMask result(whole_.mesh.n_edges(), 0);
  for (const EdgeHandle e : piece.mesh.edges()) {
    if (cut[e.idx()] != 0) result[edge_of_whole(piece, e).idx()] = 1;
  }
  return result;
}

/// But for its outline.
CutMask SeamSearch::on_piece(const Chart& piece, const CutMask& cut) const {
  CutMask result(piece.mesh.n_edges(), 0);
  for (const EdgeHandle e : piece.mesh.edges()) {
    result[e.idx()] = !piece.mesh.is_boundary(e) && cut[edge_of_whole(piece, e).idx()] != 0;
  }
  return result;
}

std::vector<Chart> SeamSearch::pieces_of(const Chart& piece, const CutMask& cut) const {
  std::vector<Chart> pieces = cut_apart(piece, on_piece(piece, cut));
  for (Chart& part : pieces) {
    for (int& v : part.source_vertex) v = piece.source_vertex[v];
    for (int& f : part.source_face) f = piece.source_face[f];
  }
  return pieces;
}

/// Opens the pieces that do not lie flat as they are.
Division SeamSearch::divide(const Chart& piece, CutMask cut) const {
  Division division{std::move(cut), {}, {}, 0, 0};
  bool opens_more = false;
  const auto take = [&](const Chart& part) {
    division.looks.push_back(look_at_whole(part));
    return division.looks.back().covered > 0;
  };
  division.pieces = pieces_of(piece, division.cut);
  for (const Chart& part : division.pieces) {
    if (!take(part) || part.mesh.n_faces() == 0) continue;
    const CutMask opening = on_whole(part, cut_to_disk(part.mesh, on_piece(part, places_.barred)));
    if (is_empty(opening)) continue;
    unite(division.cut, mirrored_.with_image(opening));
    opens_more = true;
  }
  if (opens_more) {
    division.looks.clear();
    division.pieces = pieces_of(piece, division.cut);
    for (const Chart& part : division.pieces) take(part);
  }
  double distortion = 0;
  for (const FreeLook& look : division.looks) {
    division.covered += look.covered;
    distortion += look.distortion;
  }
  const double area = surface_area(piece.mesh);
  const double length = length_of_cut(piece.mesh, on_piece(piece, division.cut));
  division.covered /= area;
  division.price = length / std::sqrt(area) + kPriceOfDistortion * distortion / area;
  return division;
}

/// Candidates, each its own mirror image where the whole chart has one.
std::vector<CutMask> SeamSearch::cuts_through(const Chart& piece) const {
  const CutMask barred = on_piece(piece, places_.barred);
  std::vector<CutMask> drawn = halving_cuts(piece.mesh, barred);
  const bool is_closed = piece.boundary_loops.empty();
  const bool is_disk = piece.boundary_loops.size() == 1 && count_handles(piece) == 0;
  drawn.push_back(is_disk || is_closed ? slit_to_far_end(piece.mesh, barred) : cut_to_disk(piece.mesh, barred));
  if (is_closed) drawn.push_back(cut_to_disk(piece.mesh, barred));
  std::vector<CutMask> cuts;
  const auto add = [&](CutMask cut) {
    const bool is_known = std::find(cuts.begin(), cuts.end(), cut) != cuts.end();
    if (!is_known && !is_empty(on_piece(piece, cut))) cuts.push_back(std::move(cut));
  };
  for (const CutMask& cut : drawn) {
    for (CutMask& symmetric : mirrored_.both_ways(on_whole(piece, cut))) add(std::move(symmetric));
  }
  for (CutMask line : mirrored_.lines_in_plane()) {
    for (std::size_t e = 0; e < line.size(); ++e) line[e] = line[e] != 0 && places_.barred[e] == 0;
    add(mirrored_.with_image(on_whole(piece, on_piece(piece, line))));
  }
  return cuts;
}

/// The best first.
std::vector<Division> SeamSearch::divisions(const Chart& piece) const {
  std::vector<Division> result;
  for (CutMask& cut : cuts_through(piece)) {
    if (!trials_.go_on()) return {};
    result.push_back(divide(piece, std::move(cut)));
  }
  const auto rank = [](const Division& division) {
    return std::make_pair(std::round(division.covered / kSamePrice), std::round(division.price / kSamePrice));
  };
  std::stable_sort(result.begin(), result.end(),
                   [&](const Division& a, const Division& b) { return rank(a) < rank(b); });
  return result;
}

std::vector<std::size_t> SeamSearch::failing_pieces(const Division& division) const {
  std::vector<std::size_t> failing;
  for (std::size_t i = 0; i < division.pieces.size(); ++i) {
    if (division.looks[i].covered > 0 || !trials_.lies_flat(division.pieces[i])) failing.push_back(i);
  }
  return failing;
}

CutMask SeamSearch::mend(const Chart& piece, int depth) const {
  const std::vector<Division> tried = divisions(piece);
  const CutMask none(whole_.mesh.n_edges(), 0);
  if (tried.empty()) return none;
  const Division* best = nullptr;
  std::vector<std::size_t> failing;
  double failing_area = 0;
  for (std::size_t i = 0; i < tried.size() && i < kMostTrials && (!best || !failing.empty()); ++i) {
    if (!trials_.go_on()) return none;
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
    const Chart& part = best->pieces[p];
    const bool is_cut = !is_empty(on_piece(part, cut));  // as the mirror image of one before it
    if (depth > 0 && !is_cut && part.mesh.n_faces() > 1) unite(cut, mend(part, depth - 1));
  }
  return cut;
}

}  // namespace

std::vector<VertexPair> propose_seams(const Chart& chart, const SeamTrials& trials, SeamPlaces places) {
  Chart whole = chart;
  std::iota(whole.source_vertex.begin(), whole.source_vertex.end(), 0);
  std::iota(whole.source_face.begin(), whole.source_face.end(), 0);
  places.barred.resize(chart.mesh.n_edges(), 0);
  const CutMask cut = SeamSearch(whole, trials, places).mend(whole, kMostDepth);
  std::vector<VertexPair> seams;
  if (!trials.go_on()) return seams;
  for (const EdgeHandle e : chart.mesh.edges()) {
    if (cut[e.idx()]) seams.push_back(source_edge(chart, chart.mesh.halfedge_handle(e, 0)));
  }
  return seams;
}

}  // namespace wirewarp
