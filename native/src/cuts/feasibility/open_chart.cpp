// SPDX-License-Identifier: GPL-3.0-or-later
#include "cuts/feasibility/open_chart.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "base/attempt.h"
#include "cuts/feasibility/bisect.h"
#include "cuts/feasibility/cut_apart.h"
#include "cuts/feasibility/cut_to_disk.h"
#include "cuts/feasibility/mirrored_cuts.h"
#include "cuts/feasibility/part_map.h"
#include "cuts/feasibility/ranks.h"
#include "energy/free_boundary_arap.h"
#include "surface/charts/chart_faults.h"
#include "surface/charts/folded_faces.h"
#include "surface/charts/isoperimetric.h"
#include "surface/mesh/geometry.h"
#include "surface/mesh/shortest_paths.h"

namespace wirewarp {
namespace {

/// Number of times that parts may be cut again. Of 64 models, 41 were flat after one cut, and 8 after their parts were
/// cut once more. No model needed a third cut.
constexpr int kMostDepth = 3;

/// Largest number of cuts of a piece that are tested with lies_flat(). With 2, garments are cut into more pieces. With
/// 5, the cuts are no better.
constexpr int kMostJudged = 3;

/// The price of a cut is its length/√area, plus this factor times its distortion/area. 43 models have these totals:
/// - factor 3: length 86, distortion 3.5
/// - factor 10: length 97, distortion 0.9
/// - factor 30: length 100, distortion 0.6
/// - factor 100: length 103, distortion 0.5
constexpr double kPriceOfDistortion = 10;

/// Two prices, or two shares of the area, count as equal if they differ by less than this value. Free maps have errors
/// of about this size.
constexpr double kSamePrice = 1e-6;

/// Quality of a chart's free map, which is its flat shape without fixed lengths.
struct Proxy {
  double covered = 0;     // area of faces that are flipped or overlap others, scene units squared
  double distortion = 0;  // E of Eq. (4), scene units squared
};

/// Returns the quality of a chart's free map, and stores a map without folds in the chart, for lies_flat().
Proxy evaluate_proxy(Chart& chart, const StopToken& stop) {
  const double area = surface_area(chart.mesh);
  const Proxy nothing{area, area};
  if (chart.error || is_outline_too_short(chart)) return nothing;
  const std::optional<Proxy> proxy = attempt([&] {
    FreeBoundaryArap free = free_boundary_arap(chart, kFreeSteps, {}, stop);
    Proxy found{0, free.energy};
    for (const int f : find_folded_faces(chart.mesh, free.uv, stop))
      found.covered += face_area(chart.mesh, FaceHandle(f));
    if (found.covered == 0) chart.free_map = std::move(free.uv);
    return std::optional(found);
  });
  return proxy.value_or(nothing);
}

struct Division {
  CutMask cut;
  std::vector<Chart> pieces;
  std::vector<Proxy> proxies;  // one per piece
  double price = 0;            // see kPriceOfDistortion
  double covered = 0;          // share of the area that is flipped or overlaps other faces
};

/// Returns the cut along the shortest path from the boundary to the vertex farthest from the boundary. On a closed
/// surface, the path starts at the vertex farthest from the first vertex.
CutMask slit_to_far_end(const HalfEdgeMesh& mesh, const CutMask& forbidden) {
  std::vector<VertexHandle> starts = boundary_vertices(mesh);
  const bool is_closed = starts.empty();
  if (is_closed) starts.push_back(farthest_vertex(shortest_paths(mesh, {VertexHandle(0)}, around(mesh, forbidden))));
  const ShortestPaths paths = shortest_paths(mesh, starts, around(mesh, forbidden));
  std::vector<HalfedgeHandle> path = path_back(mesh, paths, farthest_vertex(paths));
  // After a cut along a single edge, a closed surface would have an outline of two edges, which cannot enclose any
  // area.
  if (is_closed && path.size() == 1) path.clear();
  return cut_along(mesh, path);
}

/// Searches for a cut of a chart. Cuts are masks of the whole chart's edges, even if they cut only a part. The sources
/// of all parts are vertices and faces of the input.
class OpeningSearch {
 public:
  OpeningSearch(const Chart& whole, const std::function<bool(const Chart&)>& lies_flat, const StopToken& stop,
                const CutPlaces& places)
      : lies_flat_(lies_flat),
        stop_(stop),
        places_(places),
        mirrored_(whole, places.image),
        map_(whole),
        none_(whole.mesh.n_edges(), 0) {}

  CutMask open(const Chart& piece, int depth) const;

 private:
  std::vector<CutMask> cuts_through(const Chart& piece) const;
  std::vector<Division> divisions(const Chart& piece) const;
  Division divide(const Chart& piece, CutMask cut) const;
  std::vector<Chart> pieces_of(const Chart& piece, const CutMask& cut) const;
  std::vector<std::size_t> failing_pieces(const Division& division) const;

  const std::function<bool(const Chart&)>& lies_flat_;
  const StopToken& stop_;
  const CutPlaces& places_;
  const MirroredCuts mirrored_;
  const PartMap map_;
  const CutMask none_;
};

std::vector<Chart> OpeningSearch::pieces_of(const Chart& piece, const CutMask& cut) const {
  std::vector<Chart> pieces = cut_apart(piece, map_.on_part(piece, cut));
  for (Chart& part : pieces) {
    for (int& v : part.source_vertex) v = piece.source_vertex[v];
    for (int& f : part.source_face) f = piece.source_face[f];
  }
  return pieces;
}

/// Cuts a piece, then opens the tubes and handles of parts whose free maps are flipped or overlap themselves.
Division OpeningSearch::divide(const Chart& piece, CutMask cut) const {
  Division division{std::move(cut), {}, {}, 0, 0};
  bool opens_more = false;
  const auto take = [&](Chart& part) {
    division.proxies.push_back(evaluate_proxy(part, stop_));
    return division.proxies.back().covered > 0;
  };
  division.pieces = pieces_of(piece, division.cut);
  for (Chart& part : division.pieces) {
    if (!take(part) || part.mesh.n_faces() == 0) continue;
    const CutMask opening = map_.on_chart(part, cut_to_disk(part.mesh, map_.on_part(part, places_.forbidden)));
    if (is_empty(opening)) continue;
    unite(division.cut, mirrored_.with_image(opening));
    opens_more = true;
  }
  if (opens_more) {
    division.proxies.clear();
    division.pieces = pieces_of(piece, division.cut);
    for (Chart& part : division.pieces) take(part);
  }
  double distortion = 0;
  for (const Proxy& proxy : division.proxies) {
    division.covered += proxy.covered;
    distortion += proxy.distortion;
  }
  const double area = surface_area(piece.mesh);
  const double length = length_of_cut(piece.mesh, map_.on_part(piece, division.cut));
  division.covered /= area;
  division.price = length / std::sqrt(area) + kPriceOfDistortion * distortion / area;
  return division;
}

/// Returns candidates for cuts of a piece. They are symmetric if the whole chart is symmetric.
std::vector<CutMask> OpeningSearch::cuts_through(const Chart& piece) const {
  const CutMask forbidden = map_.on_part(piece, places_.forbidden);
  std::vector<CutMask> drawn = bisections(piece.mesh, forbidden);
  const bool is_closed = piece.boundary_loops.empty();
  const bool is_disk = piece.boundary_loops.size() == 1 && count_handles(piece) == 0;
  drawn.push_back(is_disk || is_closed ? slit_to_far_end(piece.mesh, forbidden) : cut_to_disk(piece.mesh, forbidden));
  if (is_closed) drawn.push_back(cut_to_disk(piece.mesh, forbidden));
  std::vector<CutMask> cuts;
  const auto add = [&](CutMask cut) {
    const bool is_known = std::find(cuts.begin(), cuts.end(), cut) != cuts.end();
    if (!is_known && !is_empty(map_.on_part(piece, cut))) cuts.push_back(std::move(cut));
  };
  for (const CutMask& cut : drawn) {
    for (CutMask& symmetric : mirrored_.both_ways(map_.on_chart(piece, cut))) add(std::move(symmetric));
  }
  for (CutMask line : mirrored_.lines_in_plane()) {
    for (std::size_t e = 0; e < line.size(); ++e) line[e] = line[e] != 0 && places_.forbidden[e] == 0;
    add(mirrored_.with_image(map_.on_chart(piece, map_.on_part(piece, line))));
  }
  return cuts;
}

/// Returns the divisions of a piece, the best first: the least flipped or overlapping area, then the lowest price.
std::vector<Division> OpeningSearch::divisions(const Chart& piece) const {
  std::vector<Division> found;
  std::vector<double> covered, prices;
  for (CutMask& cut : cuts_through(piece)) {
    if (!stop_.may_go_on()) return {};
    found.push_back(divide(piece, std::move(cut)));
    covered.push_back(found.back().covered);
    prices.push_back(found.back().price);
  }
  const std::vector<int> by_covered = ranks_of(covered, kSamePrice), by_price = ranks_of(prices, kSamePrice);
  std::vector<std::size_t> order(found.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(by_covered[a], by_price[a]) < std::pair(by_covered[b], by_price[b]);
  });
  std::vector<Division> result;
  for (const std::size_t i : order) result.push_back(std::move(found[i]));
  return result;
}

std::vector<std::size_t> OpeningSearch::failing_pieces(const Division& division) const {
  std::vector<std::size_t> failing;
  for (std::size_t i = 0; i < division.pieces.size(); ++i) {
    if (division.proxies[i].covered > 0 || !lies_flat_(division.pieces[i])) failing.push_back(i);
  }
  return failing;
}

CutMask OpeningSearch::open(const Chart& piece, int depth) const {
  const std::vector<Division> tried = divisions(piece);
  if (tried.empty()) return none_;
  const Division* best = nullptr;
  std::vector<std::size_t> failing;
  double failing_area = 0;
  for (std::size_t i = 0; i < tried.size() && i < kMostJudged && (!best || !failing.empty()); ++i) {
    if (!stop_.may_go_on()) return none_;
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
    const bool is_cut = !is_empty(map_.on_part(part, cut));  // whether another part's mirrored cut cuts this part
    if (depth > 0 && !is_cut && part.mesh.n_faces() > 1) unite(cut, open(part, depth - 1));
  }
  return cut;
}

}  // namespace

CutMask open_chart(const Chart& chart, const std::function<bool(const Chart&)>& lies_flat, const StopToken& stop,
                   CutPlaces places) {
  places.forbidden.resize(chart.mesh.n_edges(), 0);
  const CutMask none(chart.mesh.n_edges(), 0);
  const CutMask cut = OpeningSearch(chart, lies_flat, stop, places).open(chart, kMostDepth);
  return stop.may_go_on() ? cut : none;
}

}  // namespace wirewarp
