// SPDX-License-Identifier: GPL-3.0-or-later
#include "cuts/propose/flat_pieces.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "cuts/propose/cut_faces.h"
#include "flatten.h"
#include "newton/solve/stretched_lengths.h"
#include "surface/charts/cut_into_charts.h"
#include "surface/charts/surface_cut.h"
#include "surface/mesh/geometry.h"
#include "surface/middle_surface.h"

namespace wirewarp {
namespace {

std::shared_ptr<const FlatPiece> as_flat_piece(Chart chart, const Piece& piece, const InternalOptions& options,
                                               const NeededStretch& needed) {
  PartMap edges(chart);
  std::vector<VertexPair> outline = outline_of(chart);
  FlatPiece flat{std::move(chart), std::move(edges), std::move(outline), {}, 0, 0, 0};
  flat.chart.free_map.reset();  // to save memory
  flat.error = flat.chart.error ? flat.chart.error : piece.error;
  const Metrics& metrics = piece.metrics;
  if (!flat.chart.error) {
    flat.area = metrics.area_3d;
    flat.energy = (options.cloth ? metrics.cloth_energy : metrics.arap_energy) * metrics.area_3d;
  }
  if (!flat.error) {
    flat.strain = needed.of(piece);
    flat.uv = piece.vertices;
    flat.face_strain = needed.of_faces(piece);
    // A higher limit of factorizations may change the shape of a large chart, because its coarse start gets half of
    // this limit. With a higher limit, the comparison of a fabric's directions may also continue.
    const bool is_large = flat.chart.mesh.n_faces() >= options.large_chart;
    const bool may_turn = options.cloth && options.orientation == Orientation::best;
    flat.is_final = piece.report.termination == Termination::converged && !is_large && !may_turn;
  } else if (flat.error->has_layout) {
    flat.faulty_strain = needed.of(piece);
  }
  return std::make_shared<FlatPiece>(std::move(flat));
}

bool has_outline_edge(const FlatPiece& piece, const std::set<VertexPair>& edges) {
  return std::any_of(edges.begin(), edges.end(), [&](const VertexPair& edge) {
    return std::binary_search(piece.outline.begin(), piece.outline.end(), edge);
  });
}

using Selection = std::vector<char>;  // one flag per piece

std::vector<int> faces_of(const FlatPieces& pieces, const Selection& chosen) {
  std::vector<int> faces;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (chosen[i] == 0) continue;
    const std::vector<int>& own = pieces[i]->chart.source_face;
    faces.insert(faces.end(), own.begin(), own.end());
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

/// Returns the chosen pieces and all pieces that elastic seams couple with them.
Selection coupled(const FlatPieces& pieces, Selection chosen) {
  std::set<std::pair<int, int>> shared;  // wire index and part of each elastic seam of chosen pieces
  for (bool has_grown = true; has_grown;) {
    has_grown = false;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const std::vector<WirePart>& parts = pieces[i]->chart.wire_parts;
      const auto is_shared = [&](const WirePart& part) {
        return is_elastic_boundary(part) && shared.count({part.wire_index, part.part}) != 0;
      };
      if (chosen[i] == 0 && std::none_of(parts.begin(), parts.end(), is_shared)) continue;
      chosen[i] = 1;
      for (const WirePart& part : parts) {
        if (is_elastic_boundary(part)) has_grown |= shared.insert({part.wire_index, part.part}).second;
      }
    }
  }
  return chosen;
}

/// Returns the chosen pieces, their neighbors along outlines, and all pieces that elastic seams couple with these
/// neighbors.
Selection with_neighbors(const FlatPieces& pieces, const Selection& chosen) {
  std::set<VertexPair> outline;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (chosen[i] != 0) outline.insert(pieces[i]->outline.begin(), pieces[i]->outline.end());
  }
  Selection more = chosen;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (has_outline_edge(*pieces[i], outline)) more[i] = 1;
  }
  return coupled(pieces, std::move(more));
}

/// Selects the pieces that a cut runs through or that are beside an opened seam, and all pieces coupled with them.
Selection changed_pieces(const FlatPieces& before, const std::vector<VertexPair>& edges,
                         const std::vector<VertexPair>& opened) {
  const std::set<VertexPair> no_seams = undirected(opened);
  Selection cut(before.size(), 0);
  for (std::size_t i = 0; i < before.size(); ++i) {
    const auto is_inside = [&](const VertexPair& edge) { return before[i]->edges.edge_between(edge).is_valid(); };
    cut[i] = std::any_of(edges.begin(), edges.end(), is_inside) || has_outline_edge(*before[i], no_seams);
  }
  return coupled(before, std::move(cut));
}

using AreaOfFaces = std::map<int, double>;  // area of a piece on each face of the surface, scene units squared

AreaOfFaces areas_of(const FlatPiece& piece, const std::vector<int>& faces) {
  AreaOfFaces areas;
  for (const FaceHandle f : piece.chart.mesh.faces())
    areas[faces[piece.chart.source_face[f.idx()]]] += face_area(piece.chart.mesh, f);
  return areas;
}

double shared_area(const AreaOfFaces& a, const AreaOfFaces& b) {
  double shared = 0;
  for (const auto& [face, area] : a) {
    const auto found = b.find(face);
    if (found != b.end()) shared += std::min(area, found->second);
  }
  return shared;
}

}  // namespace

bool cuts_inside(const FlatPiece& piece, const Chart& chart) {
  const std::vector<VertexPair> outline = outline_of(chart);
  return std::any_of(outline.begin(), outline.end(),
                     [&](const VertexPair& edge) { return piece.edges.edge_between(edge).is_valid(); });
}

void sort_pieces(FlatPieces& pieces) {
  std::sort(pieces.begin(), pieces.end(),
            [](const auto& a, const auto& b) { return a->chart.source_face.front() < b->chart.source_face.front(); });
}

FlatPieces pieces_beside(const FlatPieces& pieces, const std::vector<VertexPair>& edges) {
  const std::set<VertexPair> given_edges = undirected(edges);
  FlatPieces beside;
  for (const std::shared_ptr<const FlatPiece>& piece : pieces) {
    if (has_outline_edge(*piece, given_edges)) beside.push_back(piece);
  }
  return beside;
}

PieceFigures figures_of(const FlatPieces& pieces) {
  PieceFigures figures;
  for (const std::shared_ptr<const FlatPiece>& piece : pieces) {
    if (piece->error) figures.error = piece->error;
    figures.energy += piece->energy;
    figures.area += piece->area;
    figures.strain = std::max(figures.strain, piece->strain);
    ++figures.num_pieces;
  }
  figures.energy /= figures.area;
  if (figures.error) figures.energy = figures.strain = std::numeric_limits<double>::infinity();
  return figures;
}

FlatPieces parts_of(const FlatPieces& pieces, const Chart& chart) {
  FlatPieces parts;
  std::copy_if(pieces.begin(), pieces.end(), std::back_inserter(parts),
               [&](const std::shared_ptr<const FlatPiece>& piece) { return is_part_of(piece->chart, chart); });
  return parts;
}

PieceFigures figures_of(const FlatPieces& pieces, const Chart& chart) { return figures_of(parts_of(pieces, chart)); }

FlatPieces failed_on_mesh(const PiecesOnMesh& here, const PiecesOnMesh& there, double most_strain) {
  std::vector<AreaOfFaces> areas;
  for (const std::shared_ptr<const FlatPiece>& piece : here.pieces) areas.push_back(areas_of(*piece, here.faces));
  std::vector<int> counterparts(areas.size(), 0);
  std::vector<char> has_failed(areas.size(), 0);
  for (const std::shared_ptr<const FlatPiece>& other : there.pieces) {
    const AreaOfFaces area = areas_of(*other, there.faces);
    std::vector<double> shared;
    for (const AreaOfFaces& each : areas) shared.push_back(shared_area(each, area));
    const auto same = static_cast<std::size_t>(std::max_element(shared.begin(), shared.end()) - shared.begin());
    ++counterparts[same];
    if (other->error || other->strain > most_strain) has_failed[same] = 1;
  }
  FlatPieces failed;
  for (std::size_t i = 0; i < areas.size(); ++i) {
    if (has_failed[i] != 0 || counterparts[i] != 1) failed.push_back(here.pieces[i]);
  }
  return failed;
}

double most_strain(const FlatPieces& pieces) {
  double most = 0;
  for (const std::shared_ptr<const FlatPiece>& piece : pieces) most = std::max(most, piece->strain);
  return most;
}

bool spoils_others(const FlatPieces& before, const FlatPieces& after, const Chart& chart) {
  const double most = most_strain(before);
  return std::any_of(after.begin(), after.end(), [&](const std::shared_ptr<const FlatPiece>& piece) {
    if (is_part_of(piece->chart, chart) || std::find(before.begin(), before.end(), piece) != before.end()) return false;
    if (!piece->error) return piece->strain > most + kStrainError;
    const auto same = std::find_if(before.begin(), before.end(),
                                   [&](const auto& old) { return is_part_of(piece->chart, old->chart); });
    return !(*same)->error;
  });
}

bool is_among(const std::vector<int>& faces, const Chart& part) {
  return std::binary_search(faces.begin(), faces.end(), part.source_face.front());
}

bool is_part_of(const Chart& part, const Chart& chart) { return is_among(chart.source_face, part); }

SurfaceToCut::SurfaceToCut(const FlattenInput& input, const Options& options) : input_(input) {
  fans_ = fans_of_uncut_surface(input.faces, check_request(input, options));
  if (options.thickness > 0) middle_ = move_to_middle(input, options);
}

ExactEvaluation::ExactEvaluation(const SurfaceToCut& surface, const InternalOptions& options, StopToken stop)
    : surface_(surface),
      input_(surface.middle()),
      needed_(surface.given(), options.cloth.has_value()),
      options_(options),
      stop_(std::move(stop)) {
  options_.with_proposals = false;
}

Charts ExactEvaluation::cut_chosen(const FlatPieces& pieces, const std::vector<char>& chosen,
                                   const std::vector<VertexPair>& edges, const std::vector<VertexPair>& opened) const {
  const std::set<VertexPair> no_seams = undirected(opened);
  std::vector<VertexPair> seams;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (chosen[i] == 0) continue;
    for (const VertexPair& edge : pieces[i]->outline) {
      if (no_seams.count(edge) == 0) seams.push_back(edge);
    }
    for (const VertexPair& edge : edges) {
      if (pieces[i]->edges.edge_between(edge).is_valid()) seams.push_back(edge);
    }
  }
  return cut_faces(input_, surface_.fans(), faces_of(pieces, chosen), seams, stop_);
}

FlatPieces ExactEvaluation::flatten_along_seams(Charts charts) const {
  const FlattenResult result = flatten_charts(charts, input_, options_, stop_);
  FlatPieces pieces;
  for (std::size_t c = 0; c < charts.charts.size(); ++c) {
    pieces.push_back(as_flat_piece(std::move(charts.charts[c]), result.pieces[c], options_, needed_));
  }
  return pieces;
}

FlatPieces ExactEvaluation::uncut() const {
  const EdgeTable edges(input_.faces, static_cast<int>(input_.vertices.rows()));
  return flatten_along_seams(cut_into_charts(input_, edges, stop_));
}

ChangedPieces ExactEvaluation::changed_by(const FlatPieces& before, const std::vector<VertexPair>& edges,
                                          const std::vector<VertexPair>& opened) const {
  const Selection cut = changed_pieces(before, edges, opened);
  Selection changed = cut, solved = cut;
  // If the fabric is stretched, neighbors share the lengths of seams.
  if (is_stretched(options_)) {
    changed = with_neighbors(before, cut);
    solved = with_neighbors(before, changed);  // includes all pieces on which the lengths of changed pieces depend
  }
  return {faces_of(before, cut), faces_of(before, changed), cut_chosen(before, solved, edges, opened)};
}

FlatPieces ExactEvaluation::with_changed(const FlatPieces& before, ChangedPieces changed) const {
  const auto is_changed = [&](const auto& piece) { return is_among(changed.changed_faces, piece->chart); };
  FlatPieces after;
  std::remove_copy_if(before.begin(), before.end(), std::back_inserter(after), is_changed);
  const FlatPieces flat = flatten_along_seams(std::move(changed.charts));
  std::copy_if(flat.begin(), flat.end(), std::back_inserter(after), is_changed);
  sort_pieces(after);
  return after;
}

FlattenError ExactEvaluation::explain(const FlatPieces& pieces, int piece) const {
  Selection asked(pieces.size(), 0);
  asked[piece] = 1;
  Selection solved = coupled(pieces, std::move(asked));
  if (is_stretched(options_)) solved = with_neighbors(pieces, solved);
  Charts charts{{}, {}, std::vector<char>(input_.wires.size(), 0)};
  std::size_t place = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (static_cast<int>(i) == piece) place = charts.charts.size();
    if (solved[i] != 0) charts.charts.push_back(pieces[i]->chart);
  }
  InternalOptions options = options_;
  options.with_proposals = true;
  return flatten_charts(std::move(charts), input_, options, stop_).pieces[place].error.value();
}

}  // namespace wirewarp
