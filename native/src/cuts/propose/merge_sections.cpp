// SPDX-License-Identifier: GPL-3.0-or-later
#include "cuts/propose/merge_sections.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "base/attempt.h"
#include "base/in_threads.h"
#include "cuts/feasibility/ranks.h"
#include "cuts/propose/cut_chains.h"
#include "energy/free_boundary_arap.h"
#include "energy/shape_error.h"
#include "surface/charts/folded_faces.h"
#include "surface/charts/isoperimetric.h"
#include "surface/mesh/geometry.h"
#include "surface/mesh/widespread.h"

namespace wirewarp {
namespace {

/// Lengths of sections that differ by less, as a share of the longest, are equal: the same order however the input is
/// turned.
constexpr double kSameLength = 1e-9;

/// With 20, no section goes from the finest set of a penguin, where with 40 a third of its length does.
constexpr int kMergeFactorizations = 40;

/// When no length is held, a piece has about the strain that it needs at least. Of 90 unions that were accepted on a
/// cow and a penguin, this was up to 1.09 of the strain that was allowed, and up to 2.1% of the area was flipped or
/// overlapped. By these limits three fourths of the time for all unions are saved.
constexpr double kMostFreeStrain = 1.1;
constexpr double kMostFolded = 0.025;

/// Strains below are rounding: to about this, shapes are found.
constexpr double kFlatStrain = 1e-6;

constexpr double kCannotLieFlat = std::numeric_limits<double>::infinity();

/// With an infinite limit, pieces still have to lie flat.
bool is_allowed(double strain, double limit) { return strain < kCannotLieFlat && strain <= limit; }

/// A lower estimate of the strain that a chart needs: that of its free map, divided by kMostFreeStrain. Infinite if too
/// much of the free map is folded.
double least_strain(const Chart& chart, const StopToken& stop) {
  if (chart.error || is_outline_too_short(chart)) return kCannotLieFlat;
  const auto free = attempt([&] { return std::optional(free_boundary_arap(chart, kFreeSteps, {}, stop)); });
  if (!free) return 0;
  const ShapeError shape(chart);
  std::vector<double> areas;
  Eigen::VectorXd strains(static_cast<Eigen::Index>(shape.triangles().size()));
  double area = 0, folded = 0;
  for (const ShapeError::Triangle& triangle : shape.triangles()) {
    const ShapeError::LinearMap map = ShapeError::map_of(triangle, free->uv);
    const double twice_z = map.norm_z, twice_w = std::hypot(map.w1, map.w2);
    strains[static_cast<Eigen::Index>(areas.size())] =
        std::max((twice_z + twice_w) / 2, 2 / std::abs(twice_z - twice_w)) - 1;
    areas.push_back(triangle.area);
    area += triangle.area;
  }
  for (const int f : find_folded_faces(chart.mesh, free->uv)) folded += areas[f];
  return folded > kMostFolded * area ? kCannotLieFlat : widespread(areas, strains) / kMostFreeStrain;
}

bool is_part_of(const Chart& part, const FlatPieces& pieces) {
  return std::any_of(pieces.begin(), pieces.end(),
                     [&](const auto& piece) { return wirewarp::is_part_of(part, piece->chart); });
}

bool has_eases(const FlattenInput& input) {
  return !input.eases.empty() ||
         std::any_of(input.wires.begin(), input.wires.end(), [](const Wire& wire) { return wire.ease != 0; });
}

InternalOptions without_long_runs(InternalOptions options) {
  options.max_factorizations = std::min(options.max_factorizations, kMergeFactorizations);
  options.mends_folds = false;
  return options;
}

/// A section that turns by more has a corner: a box's does so where three of its sides meet, a jagged one of triangles
/// with equal sides by 60 degrees.
constexpr double kCornerCosine = 0.45;

/// Where the second half of a section begins.
std::size_t middle_of(const HalfEdgeMesh& mesh, const HalfEdgeChain& section) {
  const double half = length_of(mesh, section) / 2;
  double passed = 0;
  std::size_t i = 0;
  while (i + 1 < section.size() && passed + edge_length(mesh, section[i]) <= half)
    passed += edge_length(mesh, section[i++]);
  return i;
}

/// Where the section begins that follows the sharpest corner; 0 if there is no corner.
std::size_t sharpest_corner_of(const HalfEdgeMesh& mesh, const HalfEdgeChain& section) {
  double least = kCornerCosine;
  std::size_t corner = 0;
  for (std::size_t i = 1; i < section.size(); ++i) {
    const double cosine =
        mesh.calc_edge_vector(section[i - 1]).normalized() | mesh.calc_edge_vector(section[i]).normalized();
    if (cosine >= least - kSameLength) continue;
    least = cosine;
    corner = i;
  }
  return corner;
}

/// Both halves of a section, and what lies before and behind its sharpest corner; none of a single edge.
std::vector<HalfEdgeChain> halves_of(const HalfEdgeMesh& mesh, const HalfEdgeChain& section) {
  const std::size_t middle = middle_of(mesh, section), corner = sharpest_corner_of(mesh, section);
  std::vector<HalfEdgeChain> halves;
  for (const std::size_t begin : {middle, corner == middle ? std::size_t{0} : corner}) {
    if (begin == 0) continue;
    const auto at = section.begin() + static_cast<std::ptrdiff_t>(begin);
    halves.emplace_back(section.begin(), at);
    halves.emplace_back(at, section.end());
  }
  return halves;
}

/// The longest first.
std::vector<HalfEdgeChain> sorted_by_length(const HalfEdgeMesh& mesh, std::vector<HalfEdgeChain> sections) {
  std::vector<double> lengths;
  for (const HalfEdgeChain& section : sections) lengths.push_back(length_of(mesh, section));
  const double longest = lengths.empty() ? 0 : *std::max_element(lengths.begin(), lengths.end());
  const std::vector<int> ranks = ranks_of(lengths, kSameLength * longest);
  std::vector<std::size_t> order(sections.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return ranks[a] > ranks[b]; });
  std::vector<HalfEdgeChain> sorted;
  for (const std::size_t i : order) sorted.push_back(std::move(sections[i]));
  return sorted;
}

}  // namespace

SectionMerger::SectionMerger(CutState state, const Chart& chart, const MirroredCuts& mirrored,
                             const ExactEvaluation& exact)
    : state_(std::move(state)),
      chart_(chart),
      mirrored_(mirrored),
      has_other_measure_(exact.options().cloth.has_value() || has_eases(exact.surface().given())),
      exact_(exact),
      quick_(exact.surface(), without_long_runs(exact.options()), exact.stop()) {}

void SectionMerger::run(double most_strain, const std::function<void(double)>& report) {
  most_strain_ = most_strain;
  report_ = report;
  while (open_one(false) || open_one(true)) continue;
}

/// Whether one more section, or half of one, could go. Several are evaluated at a time; the first that may go is taken
/// if it may also go after long runs.
bool SectionMerger::open_one(bool is_half) {
  const std::vector<CutMask> candidates = list_candidates(is_half);
  const std::size_t at_once = num_cores();
  for (std::size_t first = 0; first < candidates.size(); first += at_once) {
    report_((static_cast<double>(first) / static_cast<double>(candidates.size()) + (is_half ? 1 : 0)) / 2);
    std::vector<Trial> tried(std::min(at_once, candidates.size() - first));
    run_in_threads(
        tried.size(), num_cores(),
        [&](std::size_t i) {
          const OnOneCore on_one_core;
          tried[i] = try_without(candidates[first + i]);
        },
        [&] { exact_.stop().may_go_on(); });
    for (std::size_t i = 0; i < tried.size(); ++i) {
      const CutMask& mask = candidates[first + i];
      const FlatPieces pieces = beside(mask);
      const double allowed = allowed_beside(pieces);
      if (is_allowed(tried[i].strain, allowed)) tried[i] = without(mask, exact_);
      if (is_allowed(tried[i].strain, allowed)) {
        state_ = std::move(tried[i].after);
        return true;
      }
      rejected_[mask] = {pieces, tried[i].strain};
    }
  }
  return false;
}

/// Each its own mirror image. Those that need more strain beside the same pieces are left out.
std::vector<CutMask> SectionMerger::list_candidates(bool are_halves) const {
  std::vector<HalfEdgeChain> sections;
  for (HalfEdgeChain& whole : sections_of(chart_.mesh, state_.cut)) {
    if (are_halves) {
      for (HalfEdgeChain& half : halves_of(chart_.mesh, whole)) sections.push_back(std::move(half));
    } else {
      sections.push_back(std::move(whole));
    }
  }
  std::vector<CutMask> candidates;
  for (const HalfEdgeChain& section : sorted_by_length(chart_.mesh, std::move(sections))) {
    CutMask mask = mirrored_.with_image(cut_along(chart_.mesh, section));
    for (std::size_t e = 0; e < mask.size(); ++e) mask[e] = mask[e] != 0 && state_.cut[e] != 0;
    const auto known = rejected_.find(mask);
    if (known != rejected_.end() && known->second.beside == beside(mask) &&
        !is_allowed(known->second.strain, allowed_beside(known->second.beside)))
      continue;
    if (std::find(candidates.begin(), candidates.end(), mask) == candidates.end())
      candidates.push_back(std::move(mask));
  }
  return candidates;
}

std::vector<VertexPair> SectionMerger::edges_of(const CutMask& mask) const {
  std::vector<VertexPair> edges;
  for (const EdgeHandle e : chart_.mesh.edges()) {
    if (mask[e.idx()] != 0) edges.push_back(source_edge(chart_, chart_.mesh.halfedge_handle(e, 0)));
  }
  return edges;
}

/// The strain that may be left where there are these pieces now.
double SectionMerger::allowed_beside(const FlatPieces& pieces) const {
  return std::max({kFlatStrain, most_strain_, most_strain(pieces)});
}

/// Whether a piece of the state that has this chart has no flat shape.
bool SectionMerger::had_error(const Chart& chart) const {
  return std::any_of(state_.pieces.begin(), state_.pieces.end(),
                     [&](const auto& piece) { return piece->error && is_part_of(chart, piece->chart); });
}

/// Of free maps, up to the first piece that needs more than is allowed.
double SectionMerger::least_strain_without(const CutMask& mask, double allowed) const {
  double needed = 0;
  const FlatPieces joined = beside(mask);
  for (const Chart& chart : exact_.changed_charts(state_.pieces, {}, edges_of(mask))) {
    if (!is_part_of(chart, joined) && had_error(chart)) continue;
    const double least = least_strain(chart, exact_.stop());
    if (least == kCannotLieFlat || !has_other_measure_) needed = std::max(needed, least);
    if (!is_allowed(needed, allowed)) break;
  }
  return needed;
}

SectionMerger::Trial SectionMerger::without(const CutMask& mask, const ExactEvaluation& exact) const {
  Trial trial{0, {state_.cut, exact.with_cut(state_.pieces, {}, edges_of(mask))}};
  CutState& after = trial.after;
  const FlatPieces joined = beside(mask);
  for (std::size_t e = 0; e < mask.size(); ++e) after.cut[e] = after.cut[e] != 0 && mask[e] == 0;
  for (const std::shared_ptr<const FlatPiece>& piece : after.pieces) {
    if (std::find(state_.pieces.begin(), state_.pieces.end(), piece) != state_.pieces.end()) continue;
    if (piece->error && !is_part_of(piece->chart, joined) && had_error(piece->chart)) continue;
    trial.strain = std::max(trial.strain, piece->error ? kCannotLieFlat : piece->strain);
  }
  return trial;
}

/// Looks at what the new pieces need when no length is held before they are flattened.
SectionMerger::Trial SectionMerger::try_without(const CutMask& mask) const {
  const double allowed = allowed_beside(beside(mask)), least = least_strain_without(mask, allowed);
  return is_allowed(least, allowed) ? without(mask, quick_) : Trial{least, {}};
}

}  // namespace wirewarp
