// SPDX-License-Identifier: GPL-3.0-or-later
#include "cuts/propose/merge_sections.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>
#include <thread>
#include <utility>

#include "base/attempt.h"
#include "base/in_threads.h"
#include "cuts/feasibility/ranks.h"
#include "cuts/propose/cut_chains.h"
#include "cuts/propose/flat_width.h"
#include "energy/free_boundary_arap.h"
#include "energy/shape_error.h"
#include "surface/charts/folded_faces.h"
#include "surface/charts/isoperimetric.h"
#include "surface/mesh/geometry.h"
#include "surface/mesh/widespread.h"

namespace wirewarp {
namespace {

/// Lengths of sections that differ by less than this share of the longest section count as equal. So the order does not
/// depend on the input's orientation.
constexpr double kSameLength = 1e-9;

/// Largest number of factorizations for a joined piece; most pieces that overlap themselves use all of them. With 40,
/// sixteen models have the same sets as with 20.
constexpr int kMergeFactorizations = 20;

/// Pieces whose free maps exceed a limit are not flattened, which saves three quarters of the time.
/// - kMostFreeStrain: strain over the allowed strain, at most 1.09 in 90 accepted pieces
/// - kMostFolded: folded share of the area, at most 2.1% in these pieces
constexpr double kMostFreeStrain = 1.1;
constexpr double kMostFolded = 0.025;

/// More factorizations are assumed to lower the strain by at most this factor. For koala_low_resolution, 6 of 191 such
/// trials were accepted. Their final shapes had at least 0.97 of the strain of the first shapes.
constexpr double kMostImprovement = 1.05;

/// Solidities count as equal if they differ by less than this rounding error. For example, half a ring and the whole
/// ring have the same solidity.
constexpr double kSameSolidity = 1e-6;

constexpr double kNoFlatShape = std::numeric_limits<double>::infinity();

/// Returns whether a strain is within a limit. Even with an infinite limit, pieces must have a flat shape.
bool is_allowed(double strain, double limit) { return strain < kNoFlatShape && strain <= limit; }

/// Estimates the least strain of a chart as the strain of its free map, divided by kMostFreeStrain. A free map is a
/// flat shape without fixed lengths. If too much of it is folded, the estimate is infinite. If there is no free map,
/// the estimate is 0. Stores the free map in the chart.
double least_strain(Chart& chart, const StopToken& stop) {
  if (chart.error || is_outline_too_short(chart)) return kNoFlatShape;
  chart.free_map = attempt([&] { return std::optional(free_boundary_arap(chart, kFreeSteps, {}, stop).uv); });
  if (!chart.free_map) return 0;
  const ShapeError shape(chart);
  std::vector<double> areas;
  Eigen::VectorXd strains(static_cast<Eigen::Index>(shape.triangles().size()));
  double area = 0, folded = 0;
  for (const ShapeError::Triangle& triangle : shape.triangles()) {
    strains[static_cast<Eigen::Index>(areas.size())] =
        ShapeError::map_of(triangle, *chart.free_map).worst_stretch() - 1;
    areas.push_back(triangle.area);
    area += triangle.area;
  }
  for (const int f : find_folded_faces(chart.mesh, *chart.free_map, stop)) folded += areas[f];
  return folded > kMostFolded * area ? kNoFlatShape : widespread(areas, strains) / kMostFreeStrain;
}

bool is_in(const FlatPieces& pieces, const Chart& part) {
  return std::any_of(pieces.begin(), pieces.end(), [&](const auto& piece) { return is_part_of(part, piece->chart); });
}

FlatPieces without_those(const FlatPieces& pieces, const FlatPieces& others) {
  FlatPieces rest;
  std::copy_if(pieces.begin(), pieces.end(), std::back_inserter(rest),
               [&](const auto& piece) { return std::find(others.begin(), others.end(), piece) == others.end(); });
  return rest;
}

/// Returns whether a chart contains all of a piece, without a cut inside the piece.
bool contains(const Chart& chart, const FlatPiece& piece) {
  const std::vector<int>&all = chart.source_face, &part = piece.chart.source_face;
  return std::includes(all.begin(), all.end(), part.begin(), part.end()) && !cuts_inside(piece, chart);
}

bool has_eases(const FlattenInput& input) {
  return !input.eases.empty() ||
         std::any_of(input.wires.begin(), input.wires.end(), [](const Wire& wire) { return wire.ease != 0; });
}

InternalOptions without_long_runs(InternalOptions options) {
  options.max_factorizations = std::min(options.max_factorizations, kMergeFactorizations);
  options.makes_injective = false;
  return options;
}

/// A section has a corner where the cosine of its turn is below this value. It has corners at the corners of a box, but
/// not at turns by 60 degrees along regular triangles.
constexpr double kCornerCosine = 0.45;

/// Returns the index of the half-edge that starts the second half of a section.
std::size_t middle_of(const HalfEdgeMesh& mesh, const HalfEdgeChain& section) {
  const double half = length_of(mesh, section) / 2;
  double passed = 0;
  std::size_t i = 0;
  while (i + 1 < section.size() && passed + edge_length(mesh, section[i]) <= half)
    passed += edge_length(mesh, section[i++]);
  return i;
}

/// Returns the index of the half-edge that starts at the sharpest corner of a section; 0 if there is no corner.
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

/// Returns both halves of a section, and the parts before and after its sharpest corner; empty for a single edge.
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

std::vector<HalfEdgeChain> sorted_by_length(const HalfEdgeMesh& mesh, std::vector<HalfEdgeChain> sections) {
  std::vector<double> lengths;
  for (const HalfEdgeChain& section : sections) lengths.push_back(length_of(mesh, section));
  const double longest = lengths.empty() ? 0 : *std::max_element(lengths.begin(), lengths.end());
  std::vector<HalfEdgeChain> sorted;
  for (const std::size_t i : highest_first(lengths, kSameLength * longest)) sorted.push_back(std::move(sections[i]));
  return sorted;
}

}  // namespace

SectionMerger::SectionMerger(CutState state, const Chart& chart, const MirroredCuts& mirrored,
                             const ExactEvaluation& exact, const MergeRules& rules)
    : state_(std::move(state)),
      chart_(chart),
      mirrored_(mirrored),
      has_other_measure_(exact.options().cloth.has_value() || has_eases(exact.surface().given())),
      exact_(exact),
      quick_(exact.surface(), without_long_runs(exact.options()), exact.stop()),
      rules_(rules),
      first_(rules.narrowest) {}

void SectionMerger::run(double most_strain, const std::function<void(double)>& report) {
  most_strain_ = most_strain;
  report_ = report;
  while (open_one(Stage::sections) || open_one(Stage::halves) || open_one(Stage::narrow)) continue;
}

void SectionMerger::restart(double first) {
  first_ = first;
  comes_first_.clear();
  if (earlier_.empty()) return;
  state_ = std::move(earlier_.front());
  earlier_.clear();
}

bool SectionMerger::undo(const FlatPieces& unwanted) {
  const FlatPieces& first = earlier_.empty() ? state_.pieces : earlier_.front().pieces;
  for (const std::shared_ptr<const FlatPiece>& piece : unwanted) {
    if (std::none_of(first.begin(), first.end(), [&](const auto& own) { return contains(own->chart, *piece); }))
      unwanted_.push_back(piece);
  }
  const auto has_unwanted = [&](const FlatPieces& pieces) {
    return std::any_of(pieces.begin(), pieces.end(), [&](const auto& piece) { return is_unwanted(piece->chart); });
  };
  for (auto& [mask, trials] : known_) {
    for (Replacement& trial : trials) {
      if (!has_unwanted(trial.after)) continue;
      trial.after.clear();
      trial.strain = trial.least = kNoFlatShape;
    }
  }
  const std::size_t count = earlier_.size();
  while (has_unwanted(state_.pieces)) {
    state_ = std::move(earlier_.back());
    earlier_.pop_back();
  }
  return earlier_.size() < count;
}

bool SectionMerger::is_unwanted(const Chart& chart) const {
  return std::any_of(unwanted_.begin(), unwanted_.end(), [&](const auto& piece) { return contains(chart, *piece); });
}

/// Removes the first allowed candidate. Returns false if no candidate is allowed.
bool SectionMerger::open_one(Stage stage) {
  exact_.stop().check();
  const std::vector<CutMask> candidates = list_candidates(stage);
  const int num_stages = first_ > 0 ? 3 : 2;  // without a width, no piece is narrow
  std::vector<std::optional<Replacement>> tried(candidates.size());
  std::atomic<std::size_t> first_allowed{candidates.size()};
  const std::thread::id caller = std::this_thread::get_id();
  run_on_all_cores(candidates.size(), exact_.stop(), [&](std::size_t i) {
    if (i > first_allowed) return;
    if (std::this_thread::get_id() == caller)
      report_((static_cast<double>(i) / static_cast<double>(candidates.size()) + static_cast<int>(stage)) / num_stages);
    tried[i] = try_without(candidates[i], stage == Stage::narrow);
    if (tried[i]->after.empty()) return;
    std::size_t first = first_allowed;
    while (i < first && !first_allowed.compare_exchange_weak(first, i)) continue;
  });
  // Whether later candidates were tried depends on the number of cores, so their trials are dropped.
  for (std::size_t i = 0; i < std::min(first_allowed + 1, candidates.size()); ++i) {
    if (const Replacement* same = known(candidates[i]); same == nullptr || same->after.empty())
      known_[candidates[i]].push_back(*tried[i]);
  }
  if (first_allowed == candidates.size()) return false;
  earlier_.push_back(std::exchange(state_, replaced(candidates[first_allowed], *tried[first_allowed])));
  return true;
}

/// Returns the last trial of a section that replaces only pieces of the current state; nullptr if there is none.
const SectionMerger::Replacement* SectionMerger::known(const CutMask& mask) const {
  const auto trials = known_.find(mask);
  if (trials == known_.end()) return nullptr;
  const FlatPieces pieces = beside(mask);
  const auto has = [](const FlatPieces& all, const FlatPieces& some) {
    return std::all_of(some.begin(), some.end(),
                       [&](const auto& piece) { return std::find(all.begin(), all.end(), piece) != all.end(); });
  };
  const auto found = std::find_if(trials->second.rbegin(), trials->second.rend(), [&](const Replacement& trial) {
    return has(trial.before, pieces) && has(state_.pieces, trial.before);
  });
  return found == trials->second.rend() ? nullptr : &*found;
}

CutState SectionMerger::replaced(const CutMask& mask, const Replacement& replacement) const {
  CutState state{state_.cut, without_those(state_.pieces, replacement.before)};
  for (std::size_t e = 0; e < mask.size(); ++e) state.cut[e] = state_.cut[e] != 0 && mask[e] == 0;
  state.pieces.insert(state.pieces.end(), replacement.after.begin(), replacement.after.end());
  sort_pieces(state.pieces);
  return state;
}

/// Returns symmetric candidates for which needs_trial() is true, the longest first. Candidates beside narrow pieces
/// come first, because narrow pieces can be joined only while their neighbors have little strain.
std::vector<CutMask> SectionMerger::list_candidates(Stage stage) {
  std::vector<HalfEdgeChain> sections;
  for (HalfEdgeChain& whole : sections_of(chart_.mesh, state_.cut)) {
    if (stage != Stage::sections) {
      for (HalfEdgeChain& half : halves_of(chart_.mesh, whole)) sections.push_back(std::move(half));
    }
    if (stage != Stage::halves) sections.push_back(std::move(whole));
  }
  std::vector<CutMask> candidates;
  for (const HalfEdgeChain& section : sorted_by_length(chart_.mesh, std::move(sections))) {
    CutMask mask = mirrored_.with_image(cut_along(chart_.mesh, section));
    for (std::size_t e = 0; e < mask.size(); ++e) mask[e] = mask[e] != 0 && state_.cut[e] != 0;
    if (!needs_trial(mask, stage)) continue;
    if (std::find(candidates.begin(), candidates.end(), mask) == candidates.end())
      candidates.push_back(std::move(mask));
  }
  std::stable_partition(candidates.begin(), candidates.end(),
                        [&](const CutMask& mask) { return is_beside_narrow(mask); });
  return candidates;
}

/// Returns whether a section may be allowed in this stage. In the last stage, these are rejected sections beside narrow
/// pieces, if more factorizations may lower their strain enough.
bool SectionMerger::needs_trial(const CutMask& mask, Stage stage) {
  const Replacement* trial = known(mask);
  if (trial == nullptr) return stage != Stage::narrow;
  const double allowed = allowed_beside(beside(mask));
  if (stage == Stage::narrow) return is_allowed(trial->least, allowed) && is_beside_narrow(mask);
  return is_allowed(trial->strain, allowed);
}

bool SectionMerger::is_beside_narrow(const CutMask& mask) {
  if (first_ == 0) return false;
  const FlatPieces pieces = beside(mask);
  return std::any_of(pieces.begin(), pieces.end(), [&](const auto& piece) { return comes_first(piece); });
}

double SectionMerger::allowed_beside(const FlatPieces& pieces) const {
  return std::max({kStrainError, most_strain_, most_strain(pieces)});
}

bool SectionMerger::had_error(const Chart& chart) const {
  return std::any_of(state_.pieces.begin(), state_.pieces.end(),
                     [&](const auto& piece) { return piece->error && is_part_of(chart, piece->chart); });
}

/// Estimates from free maps the least strain that changed pieces will have. Stops at the first piece that needs more
/// than the allowed strain. joined: the pieces beside the removed section.
double SectionMerger::least_strain_of(ChangedPieces& changed, const FlatPieces& joined, double allowed) const {
  double needed = 0;
  for (Chart& chart : changed.charts.charts) {
    if (!is_among(changed.touched_faces, chart) || (!is_in(joined, chart) && had_error(chart))) continue;
    if (is_unwanted(chart)) return kNoFlatShape;
    const double least = least_strain(chart, exact_.stop());
    if (least == kNoFlatShape || !has_other_measure_) needed = std::max(needed, least);
    if (!is_allowed(needed, allowed)) break;
  }
  return needed;
}

bool SectionMerger::comes_first(const std::shared_ptr<const FlatPiece>& piece) {
  const auto [found, is_new] = comes_first_.try_emplace(piece, false);
  if (is_new) found->second = piece->error || is_narrow(*piece, first_);
  return found->second;
}

/// Returns whether a piece is too narrow, and clearly narrower than each narrow piece that it joins.
bool SectionMerger::is_too_narrow(const FlatPiece& piece, const FlatPieces& old) const {
  if (rules_.narrowest == 0) return false;
  const double width = flat_width(piece.chart.mesh, piece.uv, rules_.narrowest);
  return width < rules_.narrowest && std::none_of(old.begin(), old.end(), [&](const auto& part) {
           if (!is_part_of(part->chart, piece.chart)) return false;
           if (part->error) return true;
           const double before = flat_width(part->chart.mesh, part->uv, rules_.narrowest);
           return before < rules_.narrowest && before <= width + kWidthError * rules_.narrowest;
         });
}

/// Returns whether a piece has too little solidity, and less than each piece that it joins.
bool SectionMerger::has_long_arms(const FlatPiece& piece, const FlatPieces& old) const {
  if (rules_.least_solidity == 0) return false;
  const double share = solidity(piece);
  return share < rules_.least_solidity && std::none_of(old.begin(), old.end(), [&](const auto& part) {
           return is_part_of(part->chart, piece.chart) && (part->error || solidity(*part) <= share + kSameSolidity);
         });
}

SectionMerger::Trial SectionMerger::flattened(ChangedPieces changed, const FlatPieces& joined, double allowed,
                                              const ExactEvaluation& exact) const {
  Trial trial{exact.with_changed(state_.pieces, std::move(changed))};
  for (const std::shared_ptr<const FlatPiece>& piece : without_those(trial.pieces, state_.pieces)) {
    trial.is_final = trial.is_final && piece->is_final;
    if (piece->error && !is_in(joined, piece->chart) && had_error(piece->chart)) continue;
    trial.strain = std::max(trial.strain, piece->error ? kNoFlatShape : piece->strain);
    trial.least = std::max(trial.least, std::max(piece->strain, piece->faulty_strain) / kMostImprovement);
  }
  const bool is_hard_to_sew =
      is_allowed(trial.strain, allowed) &&
      std::any_of(trial.pieces.begin(), trial.pieces.end(), [&](const auto& piece) {
        return is_in(joined, piece->chart) && (is_too_narrow(*piece, joined) || has_long_arms(*piece, joined));
      });
  if (is_hard_to_sew) trial.strain = kNoFlatShape;
  if (trial.is_final) trial.least = trial.strain;
  return trial;
}

/// Returns an earlier trial if its new pieces are stored. Otherwise, flattens the new pieces, unless their free maps
/// already need too much strain. is_patient: whether rejected pieces get all factorizations, too.
SectionMerger::Replacement SectionMerger::try_without(const CutMask& mask, bool is_patient) const {
  const Replacement* same = known(mask);
  if (same != nullptr && !same->after.empty()) return *same;
  const FlatPieces joined = beside(mask);
  ChangedPieces changed = exact_.changed_by(state_.pieces, {}, edges_of(chart_, mask));
  const double allowed = allowed_beside(joined), least = least_strain_of(changed, joined, allowed);
  if (!is_allowed(least, allowed)) return {joined, {}, least, least};
  Trial trial = flattened(changed, joined, allowed, is_patient ? exact_ : quick_);
  const bool is_repeated = !is_patient && !trial.is_final && is_allowed(trial.strain, allowed);
  if (is_repeated) trial = flattened(std::move(changed), joined, allowed, exact_);
  if (is_patient || is_repeated) trial.least = trial.strain;
  Replacement made{without_those(state_.pieces, trial.pieces), {}, trial.strain, trial.least};
  if (is_allowed(trial.strain, allowed)) made.after = without_those(trial.pieces, state_.pieces);
  return made;
}

}  // namespace wirewarp
