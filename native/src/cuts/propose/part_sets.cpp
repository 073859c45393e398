// SPDX-License-Identifier: GPL-3.0-or-later
#include "cuts/propose/part_sets.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

#include "base/attempt.h"
#include "base/in_threads.h"
#include "cuts/feasibility/mirrored_cuts.h"
#include "cuts/parts/level_lines.h"
#include "cuts/parts/necks.h"
#include "cuts/parts/part_planes.h"
#include "cuts/propose/canonical_order.h"
#include "cuts/propose/cut_again.h"
#include "cuts/propose/cut_sets.h"
#include "cuts/propose/flat_width.h"
#include "cuts/propose/forbidden_lines.h"
#include "cuts/propose/line_evaluation.h"
#include "cuts/propose/merge_sections.h"
#include "cuts/propose/mirror_image.h"
#include "cuts/propose/needed_stretch.h"
#include "cuts/propose/smooth_sets.h"
#include "surface/mesh/geometry.h"

namespace wirewarp {
namespace {

/// Largest number of rounds. Each round divides parts by planes. A ball needs three rounds for eight equal parts, and a
/// bear seven rounds for a strain of 20%.
constexpr int kMostRounds = 8;

/// - kMostParts: models with more parts are not divided further; a rabbit has 32, joined to 12 pieces
/// - kMostPieces: sets with more pieces are not proposed; a bear of 24 cm needs up to 29
constexpr std::size_t kMostParts = 64, kMostPieces = 30;

/// Larger strains count as this strain, twice kMostStrain, so that one bad part does not outweigh all others.
constexpr double kWorst = 2;

/// Prices added to the mean strain of a divided part, to decide between planes with about the same strain:
/// - kLengthPrice: per length of the seam over √area, which is 1.8 around a ball; its seam costs 3.5% of strain
/// - kNarrowPrice: per narrow new part; so high that other planes with up to 10% more strain are preferred
constexpr double kLengthPrice = 0.02, kNarrowPrice = 0.1;

/// Least solidity of joined parts. With 0.75, half of a fish and its tail become one piece with arms; with 0.85, they
/// do not.
constexpr double kPartSolidity = 0.85;

/// A set with at most this many pieces is easy to sew, so no search along edges follows. That search finds fewer
/// pieces, but with long arms. A star has ten pieces, a rabbit twelve.
constexpr int kFewPieces = 12;

/// In a second try, parts narrower than kSmall times the least width are joined first. A banana's caps are joined to
/// its sides only if the caps come first.
constexpr double kSmall = 2;

/// Parts are not divided for less strain than this, because the number of parts grows with the inverse of the strain.
/// All fabrics allow more.
constexpr double kLeastStrain = 0.02;

/// A model without necks but with long sharp edges is not divided into parts, because its seams belong on these edges.
/// - kSharpCosine: largest cosine between the normals at a sharp edge, for half of the turn at the edge of a box
/// - kSharp: least total length of the sharp edges, over √area; 4.9 on a cube, and 0 on a cube with round edges
constexpr double kSharpCosine = 0.7, kSharp = 0.5;

/// Share of the allowed strain that parts may have until their lines are final. The final triangles beside the lines
/// change most strains by up to 2%.
constexpr double kMargin = 0.97;

/// Parts are mirror images of each other if their centroids differ by less than this share of √area of the model.
/// It is ten times the tolerance for mirrored vertices.
constexpr double kMirrored = 1e-3;

Chart alone(const HalfEdgeMesh& mesh) {
  Chart chart;
  chart.mesh = mesh;
  chart.source_vertex.resize(mesh.n_vertices());
  chart.source_face.resize(mesh.n_faces());
  std::iota(chart.source_vertex.begin(), chart.source_vertex.end(), 0);
  std::iota(chart.source_face.begin(), chart.source_face.end(), 0);
  return chart;
}

FlattenInput input_of(const HalfEdgeMesh& mesh) { return {points_of(mesh), triangles_of(mesh), VertexPairs(0, 2), {}}; }

/// Adds the lines on a chart along which a function equals `level`. values: the function at each vertex. input: the
/// mesh from which the chart is cut.
void add_lines(const FlattenInput& input, const Chart& chart, const Eigen::VectorXd& values, double level,
               std::vector<SurfacePath>& paths) {
  for (const MeshPath& line : level_lines(chart.mesh, values, level)) paths.push_back(on_input(input, chart, line));
}

double sharp_length(const HalfEdgeMesh& mesh) {
  const auto normal = [&](HalfedgeHandle h) { return mesh.calc_face_normal(mesh.face_handle(h)); };
  double length = 0;
  for (const EdgeHandle e : mesh.edges()) {
    const HalfedgeHandle h = mesh.halfedge_handle(e, 0), other = mesh.halfedge_handle(e, 1);
    if ((normal(h) | normal(other)) < kSharpCosine) length += edge_length(mesh, h);
  }
  return length;
}

/// Returns the centroid of the faces with more strain than a limit, weighted by area and excess; nullopt if there are
/// none.
std::optional<Eigen::Vector3d> strained_place(const FlatPiece& part, double limit) {
  if (part.error) return std::nullopt;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double total = 0;
  for (const FaceHandle f : part.chart.mesh.faces()) {
    const double weight = std::max(0.0, part.face_strain[f.idx()] - limit) * face_area(part.chart.mesh, f);
    sum += weight * vector_of(part.chart.mesh.calc_face_centroid(f));
    total += weight;
  }
  return total > 0 ? std::optional<Eigen::Vector3d>(sum / total) : std::nullopt;
}

/// Returns the strains for which parts are divided, the highest first: none above the larger of kSoftStrain and the
/// target. If 80% and 40% came first, a koala would have no set within 20%.
std::vector<double> limits_up_to_plush(double target) {
  std::vector<double> limits;
  for (const double allowed : allowed_strains(target, target)) {
    const double limit = std::min(allowed, std::max(target, kSoftStrain));
    if (limit >= kLeastStrain && (limits.empty() || limit > limits.back())) limits.push_back(limit);
  }
  std::reverse(limits.begin(), limits.end());
  return limits;
}

/// A mesh that is cut along some of its edges, as a separate model with its own pieces.
class CutModel {
 public:
  CutModel(const CutMesh& mesh, const std::vector<VertexPair>& edges, const ExactEvaluation& exact)
      : input_{mesh.vertices, mesh.faces, as_pairs(edges), {}},
        surface_(input_, exact.options()),
        exact_(surface_, exact.options(), exact.stop()),
        pieces_(exact_.uncut()) {}

  const FlattenInput& input() const { return input_; }
  const ExactEvaluation& exact() const { return exact_; }
  const FlatPieces& pieces() const { return pieces_; }

 private:
  const FlattenInput input_;
  const SurfaceToCut surface_;
  const ExactEvaluation exact_;
  const FlatPieces pieces_;
};

class PartSearch {
 public:
  PartSearch(const FlatPieces& pieces, std::size_t piece, const CutOptions& cut_options, const ExactEvaluation& exact,
             CutProgress& progress)
      : pieces_(pieces),
        piece_(piece),
        cut_options_(cut_options),
        exact_(exact),
        progress_(progress),
        chart_(in_canonical_order(pieces[piece]->chart, exact.stop())),
        alone_(alone(chart_.mesh)),
        own_(input_of(chart_.mesh)),
        image_(mirror_image(chart_, exact.stop())),
        size_(std::sqrt(surface_area(chart_.mesh))) {
    if (!image_.empty()) mirror_ = mirror_plane(chart_.mesh, image_);
  }

  PartSets search() {
    const std::vector<double> limits = limits_up_to_plush(cut_options_.strain.value_or(kTargetStrain));
    if (limits.empty()) return {};
    progress_.enter(0, kNecksFound);
    std::vector<SurfacePath> loops;
    for (const Neck& neck : find_necks(chart_.mesh, image_, exact_.stop()))
      add_lines(own_, alone_, neck.distance, neck.level, loops);
    if (loops.empty() && sharp_length(chart_.mesh) > kSharp * size_) return {};
    CutMesh mesh = loops.empty() ? uncut(own_) : cut_again(uncut(own_), loops);
    PartSets found;
    const bool stopped = was_stopped([&] {
      for (std::size_t i = 0; i < limits.size(); ++i) {
        const auto count = static_cast<double>(limits.size()), first = static_cast<double>(i) / count;
        progress_.enter(kNecksFound + (1 - kNecksFound) * first, kNecksFound + (1 - kNecksFound) * (first + 1 / count));
        const Division reached = divide(mesh, kMargin * limits[i]);
        if (reached == Division::no_shape || (reached == Division::strained && !found.sets.empty())) break;
        add_joined(mesh, limits[i], found);
        if (reached == Division::strained) break;
      }
    });
    if (stopped && found.sets.empty()) throw Stopped();
    found.sets = without_worse(std::move(found.sets));
    return found;
  }

 private:
  static constexpr double kNecksFound = 0.1;  // progress when the necks are found; rough, as it only affects the bar

  struct CutSet {
    DartProposal set;
    SurfaceLines lines;
    FlatPieces pieces;
    std::vector<int> faces;  // input face that contains each face of the cut mesh
    int num_narrow = 0;
    bool is_forbidden = false;  // whether a line is forbidden
  };

  /// How a division ends: with all parts within the limit, with more strain in some parts, or with parts without a flat
  /// shape.
  enum class Division { within_limit, strained, no_shape };

  Division divide(CutMesh& mesh, double limit) const;
  std::optional<Plane> best_plane(const FlatPiece& part, bool is_symmetric, double limit) const;
  double price_of(const FlatPiece& part, const Plane& plane, double limit) const;
  std::size_t partner_of(const std::vector<Eigen::Vector3d>& centroids, std::size_t part) const;
  void add_joined(const CutMesh& mesh, double limit, PartSets& found) const;
  void join(const CutMesh& mesh, const Chart& chart, const std::vector<VertexHandle>& image, double limit,
            SectionMerger& merger, std::optional<CutSet>& best) const;
  CutSet set_along(const SurfaceLines& lines) const;
  DartProposal smooth_set(const CutSet& made, double limit) const;

  const FlatPieces& pieces_;
  const std::size_t piece_;
  const CutOptions& cut_options_;
  const ExactEvaluation& exact_;
  CutProgress& progress_;
  const Chart chart_;  // in canonical order
  const Chart alone_;  // chart_ as a separate model
  const FlattenInput own_;
  const std::vector<VertexHandle> image_;  // mirror image of each vertex, or empty
  const double size_;                      // √area of the chart
  std::optional<Plane> mirror_;
};

/// Divides parts by planes until each part has at most the strain `limit`, or until there are too many parts or rounds.
PartSearch::Division PartSearch::divide(CutMesh& mesh, double limit) const {
  for (int round = 0;; ++round) {
    const CutModel model(mesh, mesh.edges, exact_);
    const FlatPieces& parts = model.pieces();
    const auto is_bad = [&](const auto& part) { return part->error || part->strain > limit; };
    if (std::none_of(parts.begin(), parts.end(), is_bad)) return Division::within_limit;
    if (round == kMostRounds || parts.size() > kMostParts) {
      const auto has_error = [](const auto& part) { return part->error.has_value(); };
      return std::any_of(parts.begin(), parts.end(), has_error) ? Division::no_shape : Division::strained;
    }
    std::vector<Eigen::Vector3d> centroids;
    for (const std::shared_ptr<const FlatPiece>& part : parts) centroids.push_back(centroid_of(part->chart.mesh));
    std::vector<SurfacePath> paths;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const std::size_t partner = partner_of(centroids, i);
      const bool has_bad_partner = partner < parts.size() && is_bad(parts[partner]);
      if (partner < i || !(is_bad(parts[i]) || has_bad_partner)) continue;
      const std::optional<Plane> best = best_plane(*parts[i], partner == i && mirror_, limit);
      if (!best) return Division::no_shape;
      const auto add = [&](const Chart& part, const Plane& plane) {
        add_lines(model.input(), part, distances_from(plane, part.mesh), 0, paths);
      };
      add(parts[i]->chart, *best);
      if (partner < parts.size() && partner > i) add(parts[partner]->chart, best->mirrored(*mirror_));
    }
    mesh = cut_again(mesh, paths);
  }
}

/// Returns the index of a part's mirror image, or the number of parts if there is none. Without a mirror plane, a part
/// is its own image.
std::size_t PartSearch::partner_of(const std::vector<Eigen::Vector3d>& centroids, std::size_t part) const {
  if (!mirror_) return part;
  const Eigen::Vector3d there = Plane{centroids[part], Eigen::Vector3d::Zero()}.mirrored(*mirror_).point;
  const auto is_there = [&](const Eigen::Vector3d& other) { return (other - there).norm() < kMirrored * size_; };
  if (is_there(centroids[part])) return part;  // tested first, because other parts may have the same centroid
  return static_cast<std::size_t>(std::find_if(centroids.begin(), centroids.end(), is_there) - centroids.begin());
}

std::optional<Plane> PartSearch::best_plane(const FlatPiece& part, bool is_symmetric, double limit) const {
  const std::vector<Plane> planes =
      planes_through(part.chart, strained_place(part, limit), is_symmetric ? mirror_ : std::nullopt);
  std::vector<double> prices(planes.size());
  run_on_all_cores(planes.size(), exact_.stop(), [&](std::size_t i) { prices[i] = price_of(part, planes[i], limit); });
  const auto best = static_cast<std::size_t>(std::min_element(prices.begin(), prices.end()) - prices.begin());
  return std::isinf(prices[best]) ? std::nullopt : std::optional(planes[best]);
}

/// Returns the price of dividing a part by a plane: the new parts' mean strain above the limit, and the sewing effort.
double PartSearch::price_of(const FlatPiece& part, const Plane& plane, double limit) const {
  const Chart own = alone(part.chart.mesh);
  const FlattenInput input = input_of(own.mesh);
  std::vector<SurfacePath> paths;
  add_lines(input, own, distances_from(plane, own.mesh), 0, paths);
  if (paths.empty()) return std::numeric_limits<double>::infinity();
  const CutMesh mesh = cut_again(uncut(input), paths);
  const CutModel model(mesh, mesh.edges, exact_);
  const double length = level_length(own.mesh, distances_from(plane, own.mesh), 0);
  double strained = 0, area = 0, price = kLengthPrice * length / std::sqrt(surface_area(own.mesh));
  for (const std::shared_ptr<const FlatPiece>& each : model.pieces()) {
    const double part_area = surface_area(each->chart.mesh);
    const double strain = each->error ? kWorst : std::min(each->strain, kWorst);
    area += part_area;
    strained += part_area * std::max(strain - limit, 0.0);
    if (is_narrow(*each, cut_options_.narrowest)) price += kNarrowPrice;
  }
  return price + strained / area;
}

/// Joins the parts of a cut mesh, and adds the best set if it is within all limits. The first added set may have more
/// strain than `limit`.
void PartSearch::add_joined(const CutMesh& mesh, double limit, PartSets& found) const {
  const CutModel model(mesh, {}, exact_);
  const Chart chart = in_canonical_order(model.pieces().front()->chart, exact_.stop());
  const CutMask cut = PartMap(chart).mask_of(mesh.edges);
  const std::vector<VertexHandle> image = mirror_image(chart, exact_.stop());
  const MirroredCuts mirrored(chart, image);
  SectionMerger merger({cut, model.exact().with_cut(model.pieces(), mesh.edges)}, chart, mirrored, model.exact(),
                       {cut_options_.narrowest, kPartSolidity});
  std::optional<CutSet> best;
  const bool stopped = was_stopped([&] { join(mesh, chart, image, limit, merger, best); });
  if (best && (best->set.strain <= limit || found.sets.empty())) {
    const double accepted = cut_options_.strain.value_or(kSoftStrain);
    found.are_sewable |= best->set.strain <= accepted && best->num_narrow == 0 && best->set.num_pieces <= kFewPieces;
    found.sets.push_back(best->set);  // stays if the caller cancels
    if (!stopped) found.sets.back() = smooth_set(*best, limit);
  }
  if (stopped) throw Stopped();
}

/// Joins the parts in up to two orders, and finds the best set. Strains below the limit count as equal. If canceled,
/// throws Stopped with the best set so far in `best`.
void PartSearch::join(const CutMesh& mesh, const Chart& chart, const std::vector<VertexHandle>& image, double limit,
                      SectionMerger& merger, std::optional<CutSet>& best) const {
  const auto rank = [&](const CutSet& each) {
    return std::tuple(std::max(each.set.strain, limit), each.num_narrow, each.set.num_pieces, each.set.length);
  };
  std::vector<int> faces;
  for (const int face : mesh.sources.faces) faces.push_back(chart_.source_face[face]);
  const double narrowest = cut_options_.narrowest;
  for (const double first : narrowest > 0 ? std::vector{narrowest, kSmall * narrowest} : std::vector{0.0}) {
    merger.restart(first);
    for (int i = 0; i < kMostMerges; ++i) {
      merger.run(kMargin * limit, [](double) {});
      const FlatPieces& joined = merger.state().pieces;
      if (joined.size() > kMostPieces) break;
      CutSet made = set_along(lines_across(own_, alone_, mesh, chart, image, merger.state().cut));
      const FlatPieces failed = failed_on_mesh({joined, faces}, {made.pieces, made.faces}, limit);
      const bool is_useful = made.pieces.size() == joined.size() && made.set.strain < kMostStrain &&
                             made.set.length <= cut_options_.longest && !made.is_forbidden;
      if (is_useful && (!best || rank(made) < rank(*best))) best = std::move(made);
      if (!merger.undo(failed)) break;
    }
    if (!best) return;  // the second order would leave too many pieces, too: on a koala, it took 27 s in vain
  }
}

/// Returns the set along the lines that do not collapse, with exact figures. The strain is infinite if a piece has no
/// flat shape.
PartSearch::CutSet PartSearch::set_along(const SurfaceLines& lines) const {
  const FlattenInput& given = exact_.surface().given();
  std::vector<SurfacePath> paths = paths_of(given, chart_, lines);
  const std::vector<char> kept = not_collapsed(given.faces, static_cast<int>(given.vertices.rows()), paths);
  CutSet made;
  made.lines = selected(lines, kept);
  paths = selected(paths, kept);
  const CutMesh cut = cut_mesh(given.vertices, given.faces, paths);
  made.faces = cut.sources.faces;
  made.is_forbidden = has_forbidden_lines(cut, cut_options_);
  const CutSurface surface(pieces_, piece_, exact_, cut);
  made.pieces = parts_of(surface.after(), surface.chart());
  made.num_narrow = count_narrow(made.pieces, cut_options_.narrowest);
  made.set.energy_before = made.set.strain_before = std::numeric_limits<double>::infinity();
  made.set = with_lines(made.set, std::move(paths), surface, figures_of(made.pieces));
  return made;
}

/// Returns a set with smoother lines. Returns the given set if it exceeds the limit, or if smoother lines would need
/// too much strain or be forbidden.
DartProposal PartSearch::smooth_set(const CutSet& made, double limit) const {
  if (made.set.strain > limit) return made.set;
  SmoothLimits limits{limit};
  limits.num_narrow = made.num_narrow;
  const std::optional<DartProposal> smooth =
      smooth_lines(made.set, made.lines, limits, {pieces_, piece_, chart_, image_}, cut_options_, exact_);
  const FlattenInput& given = exact_.surface().given();
  if (!smooth || has_forbidden_lines(cut_mesh(given.vertices, given.faces, smooth->paths), cut_options_))
    return made.set;
  return *smooth;
}

}  // namespace

bool can_be_divided(const FlatPiece& piece, const ExactEvaluation& exact) {
  const FlattenInput& given = exact.surface().given();
  return given.wires.empty() && given.eases.empty() && exact.options().thickness == 0 &&
         piece.chart.mesh.n_faces() > 0 && piece.outline.empty();
}

PartSets part_sets(const FlatPieces& pieces, std::size_t piece, const CutOptions& cut_options,
                   const ExactEvaluation& exact, CutProgress& progress) {
  return PartSearch(pieces, piece, cut_options, exact, progress).search();
}

}  // namespace wirewarp
