// SPDX-License-Identifier: GPL-3.0-or-later
#include "cuts/propose/smooth_darts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "base/in_threads.h"
#include "base/planar.h"
#include "cuts/propose/line_evaluation.h"
#include "surface/mesh/geometry.h"
#include "warp/topology/smooth_line.h"

namespace wirewarp {
namespace {

/// No dart has an elbow (radians): a geodesic has none but where it is pressed against a wire or the outline.
constexpr double kElbow = kPi / 6;

/// A line that is longer than the straight one by less than this part has no bend that one sees: with 2% it is a tenth
/// of its length aside in the middle. One with bends, which is harder to sew, has to lower the strain by a part more.
constexpr double kBend = 0.02, kGainOfBends = 0.05;

/// By how much the ends of a line are moved, over the root of the area, first and last: half of the distance between
/// the points that were tried on the coarse copy, and what one sees of a dart.
constexpr double kFirstMove = 0.1, kLastMove = 0.05;

/// Lines whose ends are moved: the best, and two more that may overtake it. With two, the best pair of a gathered skirt
/// leaves 5.4% instead of 4.2%.
constexpr std::size_t kMoved = 3;

/// A move that lowers the strain by less than this part is not followed by another.
constexpr double kLeastMove = 0.01;

struct SmoothLine {
  HalfEdgeChain chain;  // a way along edges with the same ends
  MeshPath line;
  SurfacePath path;
};

struct SmoothDart {
  SmoothLine line;
  std::optional<SmoothLine> image;  // its mirror image, if both can be cut
  LineFigures found;                // of both; without an image, of the dart alone

  /// What counts.
  double strain() const { return std::max(found.figures.strain, found.tip_strain); }
};

class SmoothDartSearch {
 public:
  SmoothDartSearch(const PieceSearch& search, const FlatPieces& pieces, std::size_t piece,
                   const CutOptions& cut_options, const ExactEvaluation& exact)
      : search_(search),
        chart_(search.chart()),
        size_(std::sqrt(surface_area(chart_.mesh))),
        cut_options_(cut_options),
        exact_(exact),
        evaluation_(pieces, piece, exact),
        finder_(chart_, search.forbidden()),
        lines_(chart_) {
    for (const EdgeHandle edge : chart_.mesh.edges()) {
      if (search.forbidden().edges[edge.idx()] != 0) lines_.add(chart_.mesh, chart_.mesh.halfedge_handle(edge, 0));
    }
  }

  std::vector<DartProposal> search();

 private:
  std::optional<SmoothLine> line_along(const HalfEdgeChain& chain, Nearness nearness) const;
  std::optional<SmoothDart> dart_along(SmoothLine line, Nearness nearness) const;
  std::optional<SmoothDart> best_dart_along(const HalfEdgeChain& chain) const;
  std::vector<SmoothDart> evaluate(const std::vector<HalfEdgeChain>& chains);
  SmoothDart move_ends(SmoothDart dart);
  std::vector<HalfEdgeChain> moved(const SmoothDart& dart, double step) const;
  void propose(const SmoothDart& dart, std::vector<DartProposal>& proposals) const;
  bool is_worth_sewing(const LineFigures& found) const;
  DartProposal proposal_of(const SmoothLine& line, const LineFigures& found) const;

  const PieceSearch& search_;
  const Chart& chart_;
  const double size_;
  const CutOptions& cut_options_;
  const ExactEvaluation& exact_;
  const LineEvaluation evaluation_;
  const SmoothPathFinder finder_;
  WireMask lines_;
  std::map<CutEnds, std::optional<SmoothDart>> evaluated_;
};

/// A smooth line with the ends of a chain; none if it has an elbow, touches a wire or the outline, or is too long.
std::optional<SmoothLine> SmoothDartSearch::line_along(const HalfEdgeChain& chain, Nearness nearness) const {
  const HalfEdgeMesh& mesh = chart_.mesh;
  std::vector<VertexHandle> way{mesh.from_vertex_handle(chain.front())};
  for (const HalfedgeHandle h : chain) way.push_back(mesh.to_vertex_handle(h));
  SmoothLine smooth{chain, smooth_line(mesh, lines_, way, nearness), {}};
  const bool touches = std::any_of(smooth.line.begin() + 1, smooth.line.end(), [&](const PathPoint& point) {
    return point.is_vertex() && lines_.has(point.vertex);
  });
  if (touches || path_length(mesh, smooth.line) > cut_options_.longest || sharpest_turn(mesh, smooth.line) > kElbow) {
    return std::nullopt;
  }
  smooth.path = on_input(exact_.surface().given(), chart_, smooth.line);
  return smooth;
}

/// With its mirror image, unless both would meet and so cut the piece otherwise than each alone.
std::optional<SmoothDart> SmoothDartSearch::dart_along(SmoothLine line, Nearness nearness) const {
  SmoothDart dart{std::move(line), {}, {}};
  const HalfEdgeChain image = search_.image_of(dart.line.chain);
  if (!image.empty()) dart.image = line_along(image, nearness);
  std::optional<LineFigures> found;
  if (dart.image) {
    found = evaluation_.figures_along({dart.line.path, dart.image->path});
    if (!found) dart.image.reset();
  }
  if (!found) found = evaluation_.figures_along({dart.line.path});
  if (!found) return std::nullopt;
  dart.found = std::move(*found);
  return dart;
}

/// Straight, unless a line beside the chain, which follows its bends, gains clearly more.
std::optional<SmoothDart> SmoothDartSearch::best_dart_along(const HalfEdgeChain& chain) const {
  std::optional<SmoothLine> straight = line_along(chain, Nearness::anywhere);
  std::optional<SmoothLine> bent = line_along(chain, Nearness::touching);
  const auto length = [&](const SmoothLine& line) { return path_length(chart_.mesh, line.line); };
  if (straight && bent && length(*bent) <= (1 + kBend) * length(*straight)) bent.reset();
  std::optional<SmoothDart> best, other;
  if (straight) best = dart_along(std::move(*straight), Nearness::anywhere);
  if (bent) other = dart_along(std::move(*bent), Nearness::touching);
  const bool is_better = other && (!best || other->strain() <= (1 - kGainOfBends) * best->strain());
  return is_better ? other : best;
}

/// Those that have figures, in order, each once.
std::vector<SmoothDart> SmoothDartSearch::evaluate(const std::vector<HalfEdgeChain>& chains) {
  const auto ends_of = [&](const HalfEdgeChain& chain) {
    return CutEnds{chart_.mesh.from_vertex_handle(chain.front()), chart_.mesh.to_vertex_handle(chain.back())};
  };
  std::vector<const HalfEdgeChain*> fresh;
  std::vector<CutEnds> wanted;
  for (const HalfEdgeChain& chain : chains) {
    const CutEnds ends = ends_of(chain);
    if (std::find(wanted.begin(), wanted.end(), ends) != wanted.end()) continue;
    wanted.push_back(ends);
    if (evaluated_.count(ends) == 0) fresh.push_back(&chain);
  }
  std::vector<std::optional<SmoothDart>> darts(fresh.size());
  run_in_threads(
      fresh.size(), num_cores(),
      [&](std::size_t i) {
        const OnOneCore on_one_core;
        darts[i] = best_dart_along(*fresh[i]);
      },
      [&] { exact_.stop().may_go_on(); });
  for (std::size_t i = 0; i < fresh.size(); ++i) evaluated_.emplace(ends_of(*fresh[i]), std::move(darts[i]));
  std::vector<SmoothDart> found;
  for (const CutEnds& ends : wanted) {
    const std::optional<SmoothDart>& dart = evaluated_.at(ends);
    if (dart) found.push_back(*dart);
  }
  return found;
}

/// Ways whose start or tip lies about a step away: along the outline, and on, back and to both sides.
std::vector<HalfEdgeChain> SmoothDartSearch::moved(const SmoothDart& dart, double step) const {
  const HalfEdgeMesh& mesh = chart_.mesh;
  const VertexHandle start = dart.line.line.front().vertex, tip = dart.line.line.back().vertex;
  const HalfEdgeMesh::Point at = mesh.point(tip), from = mesh.point(start);
  const auto nearest = [&](const HalfEdgeMesh::Point& place, bool is_on_outline) {
    VertexHandle best;
    for (const VertexHandle v : mesh.vertices()) {
      if (mesh.is_boundary(v) != is_on_outline || finder_.is_forbidden(v) || lines_.has(v) != is_on_outline) continue;
      if (!best.is_valid() || (mesh.point(v) - place).sqrnorm() < (mesh.point(best) - place).sqrnorm()) best = v;
    }
    return best;
  };
  const HalfEdgeMesh::Point along = (at - position(mesh, dart.line.line[dart.line.line.size() - 2])).normalized();
  HalfEdgeMesh::Point normal(0, 0, 0);
  for (const FaceHandle f : mesh.vf_range(tip)) normal += mesh.calc_face_normal(f);
  const HalfEdgeMesh::Point aside = (normal % along).normalized();
  std::set<CutEnds> ends;
  for (const HalfEdgeMesh::Point& way : {along, -along, aside, -aside}) {
    ends.insert({start, nearest(at + way * (step * size_), false)});
  }
  const HalfedgeHandle out = mesh.halfedge_handle(start);  // along the outline: it has no face
  for (const HalfEdgeMesh::Point& way : {mesh.point(mesh.to_vertex_handle(out)) - from,
                                         mesh.point(mesh.from_vertex_handle(mesh.prev_halfedge_handle(out))) - from}) {
    ends.insert({nearest(from + way.normalized() * (step * size_), true), tip});
  }
  std::vector<HalfEdgeChain> chains;
  for (const CutEnds& each : ends) {
    if (!each.start.is_valid() || !each.end.is_valid() || each == CutEnds{start, tip}) continue;
    HalfEdgeChain chain = chain_of(finder_, each);
    if (!chain.empty()) chains.push_back(std::move(chain));
  }
  return chains;
}

/// To the best neighbor as long as that is clearly better, by shorter and shorter steps.
SmoothDart SmoothDartSearch::move_ends(SmoothDart dart) {
  for (double step = kFirstMove; step >= kLastMove;) {
    std::vector<SmoothDart> neighbors = evaluate(moved(dart, step));
    const auto best =
        std::min_element(neighbors.begin(), neighbors.end(),
                         [](const SmoothDart& a, const SmoothDart& b) { return a.strain() < b.strain(); });
    if (best != neighbors.end() && best->strain() <= (1 - kLeastMove) * dart.strain()) {
      dart = std::move(*best);
    } else {
      step /= 2;
    }
  }
  return dart;
}

bool SmoothDartSearch::is_worth_sewing(const LineFigures& found) const {
  PieceFigures figures = found.figures;
  figures.strain = std::max(figures.strain, found.tip_strain);
  return search_.is_worth_sewing(figures);
}

DartProposal SmoothDartSearch::proposal_of(const SmoothLine& line, const LineFigures& found) const {
  DartProposal proposal;
  proposal.edges = found.edges;
  proposal.paths = {line.path};
  proposal.length = path_length(chart_.mesh, line.line);
  proposal.num_pieces = found.figures.num_pieces;
  proposal.energy = found.figures.energy;
  proposal.energy_before = search_.before().energy;
  proposal.strain = found.figures.strain;
  proposal.strain_before = search_.before().strain;
  return proposal;
}

/// Adds a dart and its mirror image if they are worth it: together, or each alone where two are no better.
void SmoothDartSearch::propose(const SmoothDart& dart, std::vector<DartProposal>& proposals) const {
  if (!dart.image) {
    if (is_worth_sewing(dart.found)) proposals.push_back(proposal_of(dart.line, dart.found));
    return;
  }
  const std::optional<LineFigures> alone = evaluation_.figures_along({dart.line.path});
  const std::optional<LineFigures> image = evaluation_.figures_along({dart.image->path});
  if (!alone || !image) return;
  const bool helps_alone = is_worth_sewing(*alone);
  const bool are_better = is_worth_sewing(dart.found) &&
                          (!helps_alone || (dart.found.figures.energy <= (1 - kLeastMove) * alone->figures.energy &&
                                            dart.found.figures.strain <= alone->figures.strain));
  if (!helps_alone && !are_better) return;
  const int place = static_cast<int>(proposals.size());
  proposals.push_back(proposal_of(dart.line, *alone));
  proposals.push_back(proposal_of(*dart.image, *image));
  for (const int k : {place, place + 1}) {
    proposals[k].twin = 2 * place + 1 - k;
    if (!are_better) continue;
    proposals[k].energy_with_twin = dart.found.figures.energy;
    proposals[k].strain_with_twin = dart.found.figures.strain;
  }
}

std::vector<DartProposal> SmoothDartSearch::search() {
  std::vector<SmoothDart> darts = evaluate(search_.candidates());
  const auto sort = [&] {
    std::stable_sort(darts.begin(), darts.end(),
                     [](const SmoothDart& a, const SmoothDart& b) { return a.strain() < b.strain(); });
  };
  sort();
  for (std::size_t i = 0; i < std::min(kMoved, darts.size()); ++i) {
    if (darts[i].strain() <= (1 - kLeastMove) * search_.before().strain) darts[i] = move_ends(std::move(darts[i]));
  }
  sort();
  std::vector<const SmoothDart*> best;
  std::vector<DartProposal> proposals;
  for (const SmoothDart& dart : darts) {
    const bool is_known = std::any_of(best.begin(), best.end(), [&](const SmoothDart* better) {
      return search_.is_beside(better->line.chain, dart.line.chain) ||
             (better->image && search_.is_beside(better->image->chain, dart.line.chain));
    });
    if (is_known || static_cast<int>(best.size()) == cut_options_.count) continue;
    const std::size_t before = proposals.size();
    propose(dart, proposals);
    if (proposals.size() > before) best.push_back(&dart);
  }
  if (proposals.empty()) throw none_helps(search_.input_chart(), CutKind::dart, search_.before().strain);
  return proposals;
}

}  // namespace

std::vector<DartProposal> smooth_darts(const PieceSearch& search, const FlatPieces& pieces, std::size_t piece,
                                       const CutOptions& cut_options, const ExactEvaluation& exact) {
  search.check_strain();
  return SmoothDartSearch(search, pieces, piece, cut_options, exact).search();
}

}  // namespace wirewarp
