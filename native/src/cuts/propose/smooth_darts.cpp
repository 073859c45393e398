// SPDX-License-Identifier: GPL-3.0-or-later
#include "cuts/propose/smooth_darts.h"

#include <algorithm>
#include <array>
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

/// Largest turn of a dart at a point, in radians. A geodesic turns only at a wire or at the outline. A turn by twice
/// this angle is conspicuous on the flat piece.
constexpr double kElbow = kPi / 12;

/// - kBend: a bend is visible if it makes a line longer by this share, and moves its middle by a tenth of its length
/// - kGainOfBends: a bent line is harder to sew, so it must leave less strain by this share, as for kWorthElbows
constexpr double kBend = 0.02, kGainOfBends = 0.05;

/// First and last distance by which the ends of a line are moved, over √area. The first is half the distance between
/// candidate points, the last is the smallest visible change.
constexpr double kFirstMove = 0.1, kLastMove = 0.05;

/// Number of lines whose ends are moved: the best line, and two more that may become better. With two lines, the best
/// pair of a gathered skirt leaves a strain of 5.4% instead of 4.2%.
constexpr std::size_t kMoved = 3;

/// A move of an end must lower the strain by at least this share. A mirrored pair must lower the energy by at least
/// this share compared with one dart. The value is that of kLeastStep, for moves on the coarse copy.
constexpr double kLeastMove = 0.01;

/// A tip puckers if the strain around it exceeds both the strain of the uncut piece and this strain, which every fabric
/// allows.
constexpr double kAnyFabric = 0.03;

/// The course of a line: straight, or along the bends of the chain with the same ends.
enum class Course { straight, bent };

struct SmoothLine {
  HalfEdgeChain chain;  // edges between the ends of the line
  MeshPath line;
  SurfacePath path;
};

struct SmoothDart {
  SmoothLine line;
  Course course;
  std::optional<SmoothLine> image;  // mirror image of the line, if both can be cut
  LineFigures found;                // figures of both lines, or of `line` alone if there is no image or a tip puckers
  bool are_both = false;            // whether `found` is for both lines

  double strain() const { return found.figures.strain; }
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
        pieces_(pieces),
        piece_(piece),
        finder_(chart_, search.forbidden()),
        lines_(chart_) {
    CutMask barriers = PartMap(chart_).mask_of(as_list(cut_options.no_crossing));
    unite(barriers, search.forbidden().edges);
    for (const EdgeHandle edge : chart_.mesh.edges()) {
      if (barriers[edge.idx()] != 0) lines_.add(chart_.mesh, chart_.mesh.halfedge_handle(edge, 0));
    }
  }

  std::vector<DartProposal> search(const std::vector<HalfEdgeChain>& chains);

 private:
  /// A line to try. It has the same ends as the chain, and is identified by these ends and its course.
  struct Way {
    HalfEdgeChain chain;
    Course course;
  };
  using WayKey = std::pair<CutEnds, Course>;

  std::optional<SmoothLine> line_along(const Way& way) const;
  std::optional<SmoothLine> image_of(const SmoothLine& line) const;
  bool touches_lines(const MeshPath& path) const;
  std::optional<SmoothDart> dart_along(const Way& way) const;
  std::optional<LineFigures> figures_along(const std::vector<SurfacePath>& lines) const {
    return figures_with_lines(pieces_, piece_, lines, exact_);
  }
  std::vector<SmoothDart> evaluate(const std::vector<Way>& ways);
  std::vector<SmoothDart> best_courses(const std::vector<HalfEdgeChain>& chains);
  SmoothDart move_ends(SmoothDart dart);
  std::vector<Way> moved(const SmoothDart& dart, double step) const;
  std::set<CutEnds> moved_ends(const SmoothDart& dart, double step) const;
  std::vector<SmoothDart> without_neighbors(std::vector<SmoothDart> darts) const;
  void propose(const std::vector<SmoothDart>& darts, std::vector<DartProposal>& proposals) const;
  bool puckers(const LineFigures& found) const;
  bool is_better(const SmoothDart& a, const SmoothDart& b) const;
  bool is_worth_sewing(const LineFigures& found) const;
  DartProposal proposal_of(const SmoothLine& line, const LineFigures& found) const;

  const PieceSearch& search_;
  const Chart& chart_;
  const double size_;
  const CutOptions& cut_options_;
  const ExactEvaluation& exact_;
  const FlatPieces& pieces_;
  const std::size_t piece_;
  const SmoothPathFinder finder_;
  WireMask lines_;
  std::map<WayKey, std::optional<SmoothDart>> evaluated_;
};

/// Returns the smooth line of a way; nullopt if it has an elbow, is too long, or touches a wire, a forbidden edge or
/// the outline. Also returns nullopt for a bent line that is almost straight.
std::optional<SmoothLine> SmoothDartSearch::line_along(const Way& way) const {
  const HalfEdgeMesh& mesh = chart_.mesh;
  const std::vector<VertexHandle> vertices = vertices_along(mesh, way.chain);
  const auto line = [&](Nearness nearness) { return smooth_line(mesh, lines_, vertices, nearness); };
  SmoothLine smooth{way.chain, line(way.course == Course::bent ? Nearness::touching : Nearness::anywhere), {}};
  const double length = path_length(mesh, smooth.line);
  if (way.course == Course::bent && length <= (1 + kBend) * path_length(mesh, line(Nearness::anywhere))) return {};
  if (touches_lines(smooth.line) || length > cut_options_.longest || sharpest_turn(mesh, smooth.line) > kElbow)
    return {};
  smooth.path = on_input(exact_.surface().given(), chart_, smooth.line);
  return smooth;
}

/// Returns whether a path touches a wire, a forbidden edge or the outline after its start.
bool SmoothDartSearch::touches_lines(const MeshPath& path) const {
  return std::any_of(path.begin() + 1, path.end(), [&](const PathPoint& point) {
    return point.is_vertex() ? lines_.has(point.vertex) : lines_.has(chart_.mesh.edge_handle(point.half_edge));
  });
}

/// Returns the mirror image of a line; nullopt if the image cannot be cut. Mirrors the line, because a new geodesic
/// along the mirrored chain may pass a hill on the other side.
std::optional<SmoothLine> SmoothDartSearch::image_of(const SmoothLine& line) const {
  SmoothLine image{search_.image_of(line.chain), {}, {}};
  if (image.chain.empty()) return {};
  image.line = search_.image_of(line.line);
  if (image.line.empty() || touches_lines(image.line)) return {};
  image.path = on_input(exact_.surface().given(), chart_, image.line);
  return image;
}

/// Returns a dart with its figures; nullopt if it cannot be cut. Evaluates the dart together with its mirror image if
/// both can be cut without a puckering tip.
std::optional<SmoothDart> SmoothDartSearch::dart_along(const Way& way) const {
  std::optional<SmoothLine> line = line_along(way);
  if (!line) return {};
  SmoothDart dart{std::move(*line), way.course, {}, {}};
  dart.image = image_of(dart.line);
  std::optional<LineFigures> found;
  if (dart.image) {
    found = figures_along({dart.line.path, dart.image->path});
    if (!found) dart.image.reset();
    dart.are_both = found && !puckers(*found);
  }
  if (!dart.are_both) found = figures_along({dart.line.path});
  if (!found) return {};
  dart.found = std::move(*found);
  return dart;
}

/// Returns the darts that can be cut along these ways, each once, in the order of the ways.
std::vector<SmoothDart> SmoothDartSearch::evaluate(const std::vector<Way>& ways) {
  const auto key_of = [&](const Way& way) {
    const HalfEdgeMesh& mesh = chart_.mesh;
    return WayKey{{mesh.from_vertex_handle(way.chain.front()), mesh.to_vertex_handle(way.chain.back())}, way.course};
  };
  std::vector<const Way*> fresh;
  std::vector<WayKey> wanted;
  for (const Way& way : ways) {
    const WayKey key = key_of(way);
    if (std::find(wanted.begin(), wanted.end(), key) != wanted.end()) continue;
    wanted.push_back(key);
    if (evaluated_.count(key) == 0) fresh.push_back(&way);
  }
  std::vector<std::optional<SmoothDart>> darts(fresh.size());
  run_on_all_cores(fresh.size(), exact_.stop(), [&](std::size_t i) { darts[i] = dart_along(*fresh[i]); });
  for (std::size_t i = 0; i < fresh.size(); ++i) evaluated_.emplace(key_of(*fresh[i]), std::move(darts[i]));
  std::vector<SmoothDart> found;
  for (const WayKey& key : wanted) {
    const std::optional<SmoothDart>& dart = evaluated_.at(key);
    if (dart) found.push_back(*dart);
  }
  return found;
}

/// Returns at most one dart for each chain: the straight dart, or the bent dart if it is clearly better or the straight
/// dart cannot be cut.
std::vector<SmoothDart> SmoothDartSearch::best_courses(const std::vector<HalfEdgeChain>& chains) {
  std::vector<Way> ways;
  for (const HalfEdgeChain& chain : chains) {
    for (const Course course : {Course::straight, Course::bent}) ways.push_back({chain, course});
  }
  std::vector<SmoothDart> best;
  for (SmoothDart& dart : evaluate(ways)) {
    const bool is_other = dart.course == Course::bent && !best.empty() && best.back().line.chain == dart.line.chain;
    if (!is_other) {
      best.push_back(std::move(dart));
    } else if (is_better(dart, best.back()) &&
               (puckers(best.back().found) || dart.strain() <= (1 - kGainOfBends) * best.back().strain())) {
      best.back() = std::move(dart);
    }
  }
  return best;
}

/// Returns ways with a moved start or tip. step: approximate distance, over √area.
std::vector<SmoothDartSearch::Way> SmoothDartSearch::moved(const SmoothDart& dart, double step) const {
  const MeshPath& line = dart.line.line;
  std::vector<Way> ways;
  for (const CutEnds& ends : moved_ends(dart, step)) {
    if (!ends.start.is_valid() || !ends.end.is_valid()) continue;
    if (ends == CutEnds{line.front().vertex, line.back().vertex}) continue;
    HalfEdgeChain chain = chain_of(finder_, ends);
    if (!chain.empty()) ways.push_back({std::move(chain), dart.course});
  }
  return ways;
}

/// Returns ends whose start is moved along the outline, or whose tip is moved forwards, backwards or to a side. A moved
/// end is invalid if no vertex may be an end.
std::set<CutEnds> SmoothDartSearch::moved_ends(const SmoothDart& dart, double step) const {
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
  const HalfedgeHandle out = mesh.halfedge_handle(start);  // runs along the outline, without a face
  for (const HalfEdgeMesh::Point& way : {mesh.point(mesh.to_vertex_handle(out)) - from,
                                         mesh.point(mesh.from_vertex_handle(mesh.prev_halfedge_handle(out))) - from}) {
    ends.insert({nearest(from + way.normalized() * (step * size_), true), tip});
  }
  return ends;
}

/// Moves the ends of a dart to the ends of the best neighboring dart, as long as that dart is clearly better. Then
/// tries shorter steps.
SmoothDart SmoothDartSearch::move_ends(SmoothDart dart) {
  for (double step = kFirstMove; step >= kLastMove;) {
    std::vector<SmoothDart> neighbors = evaluate(moved(dart, step));
    const auto best = std::min_element(neighbors.begin(), neighbors.end(),
                                       [&](const SmoothDart& a, const SmoothDart& b) { return is_better(a, b); });
    const bool is_move = best != neighbors.end() && is_better(*best, dart) &&
                         (puckers(dart.found) || best->strain() <= (1 - kLeastMove) * dart.strain());
    if (is_move) {
      dart = std::move(*best);
    } else {
      step /= 2;
    }
  }
  return dart;
}

bool SmoothDartSearch::puckers(const LineFigures& found) const {
  return found.tip_strain > std::max(search_.before().strain, kAnyFabric);
}

/// Darts with puckering tips rank last, so that they do not displace good darts.
bool SmoothDartSearch::is_better(const SmoothDart& a, const SmoothDart& b) const {
  return std::pair(puckers(a.found), a.strain()) < std::pair(puckers(b.found), b.strain());
}

bool SmoothDartSearch::is_worth_sewing(const LineFigures& found) const {
  return search_.is_worth_sewing(found.figures) && !puckers(found);
}

DartProposal SmoothDartSearch::proposal_of(const SmoothLine& line, const LineFigures& found) const {
  DartProposal proposal = search_.proposal_with(found.figures);
  proposal.edges = found.edges;
  proposal.paths = {line.path};
  proposal.length = path_length(chart_.mesh, line.line);
  return proposal;
}

/// Adds each dart that is worth sewing alone or together with its mirror image. Also adds the mirror image if it is
/// worth sewing in one of these ways.
void SmoothDartSearch::propose(const std::vector<SmoothDart>& darts, std::vector<DartProposal>& proposals) const {
  std::vector<std::array<std::optional<LineFigures>, 2>> each(darts.size());
  run_on_all_cores(2 * darts.size(), exact_.stop(), [&](std::size_t i) {
    const SmoothDart& dart = darts[i / 2];
    if (i % 2 == 1 && !dart.image) return;
    const bool is_known = i % 2 == 0 && !dart.are_both;
    each[i / 2][i % 2] = is_known ? dart.found : figures_along({i % 2 == 0 ? dart.line.path : dart.image->path});
  });
  for (std::size_t i = 0; i < darts.size(); ++i) {
    const SmoothDart& dart = darts[i];
    const auto& [alone, image] = each[i];
    if (!alone) continue;
    const bool helps_alone = is_worth_sewing(*alone);
    const bool are_better = image && dart.are_both && is_worth_sewing(dart.found) &&
                            (!helps_alone || (dart.found.figures.energy <= (1 - kLeastMove) * alone->figures.energy &&
                                              dart.found.figures.strain <= alone->figures.strain));
    if (!helps_alone && !are_better) continue;
    std::optional<DartProposal> other;
    if (image && (are_better || is_worth_sewing(*image))) other = proposal_of(*dart.image, *image);
    std::optional<PieceFigures> both;
    if (are_better) both = dart.found.figures;
    add_with_image(proposal_of(dart.line, *alone), std::move(other), both, proposals);
  }
}

/// Returns darts, the best first. No dart is beside a better dart or its mirror image.
std::vector<SmoothDart> SmoothDartSearch::without_neighbors(std::vector<SmoothDart> darts) const {
  std::stable_sort(darts.begin(), darts.end(),
                   [&](const SmoothDart& a, const SmoothDart& b) { return is_better(a, b); });
  std::vector<SmoothDart> best;
  for (SmoothDart& dart : darts) {
    const bool is_known = std::any_of(best.begin(), best.end(), [&](const SmoothDart& better) {
      return search_.is_beside(better.line.chain, dart.line.chain) ||
             (better.image && search_.is_beside(better.image->chain, dart.line.chain));
    });
    if (!is_known) best.push_back(std::move(dart));
  }
  return best;
}

std::vector<DartProposal> SmoothDartSearch::search(const std::vector<HalfEdgeChain>& chains) {
  std::vector<SmoothDart> darts = best_courses(chains);
  std::stable_sort(darts.begin(), darts.end(),
                   [&](const SmoothDart& a, const SmoothDart& b) { return is_better(a, b); });
  for (std::size_t i = 0; i < std::min(kMoved, darts.size()); ++i) {
    if (darts[i].strain() <= (1 - kLeastMove) * search_.before().strain) darts[i] = move_ends(std::move(darts[i]));
  }
  std::vector<DartProposal> proposals;
  propose(without_neighbors(std::move(darts)), proposals);
  return proposals;
}

}  // namespace

std::vector<DartProposal> smooth_darts(const PieceSearch& search, const std::vector<HalfEdgeChain>& chains,
                                       const FlatPieces& pieces, std::size_t piece, const CutOptions& cut_options,
                                       const ExactEvaluation& exact) {
  return SmoothDartSearch(search, pieces, piece, cut_options, exact).search(chains);
}

}  // namespace wirewarp
