// SPDX-License-Identifier: GPL-3.0-or-later
#include "cuts/propose/rank_cuts.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>

#include "base/in_threads.h"
#include "cuts/propose/coarse_evaluation.h"
#include "surface/mesh/geometry.h"

namespace wirewarp {
namespace {

/// If a move of an end lowers the energy by less than this share, no further move is tried. Finer differences are left
/// to exact evaluations. With 2%, the second and third best cuts become worse.
constexpr double kLeastStep = 0.01;

class CutSearch {
 public:
  CutSearch(const Chart& chart, const SmoothPathFinder& paths, const InternalOptions& options, double longest,
            const StopToken& stop)
      : chart_(chart), paths_(paths), coarse_(chart, options, stop), longest_(longest), stop_(stop) {}

  void try_all(const std::vector<CutEnds>& cuts);
  RankedCut improve(RankedCut cut);
  std::vector<RankedCut> ranked() const;
  double energy_uncut() const { return coarse_.energy_uncut(); }
  std::size_t num_tried() const { return energies_.size(); }

 private:
  const Chart& chart_;
  const SmoothPathFinder& paths_;
  const CoarseEvaluation coarse_;
  const double longest_;
  const StopToken& stop_;
  std::map<VertexHandle, SmoothPaths> paths_from_;  // keyed by the start of tried cuts
  std::map<CutEnds, double> energies_;
};

void CutSearch::try_all(const std::vector<CutEnds>& cuts) {
  std::vector<CutEnds> fresh;
  std::copy_if(cuts.begin(), cuts.end(), std::back_inserter(fresh),
               [&](const CutEnds& cut) { return energies_.count(cut) == 0; });
  for (const CutEnds& cut : fresh) {
    if (paths_from_.count(cut.start) == 0) paths_from_[cut.start] = paths_.paths_from(cut.start);
  }
  std::vector<double> energies(fresh.size(), std::numeric_limits<double>::infinity());
  run_on_all_cores(fresh.size(), stop_, [&](std::size_t i) {
    stop_.check();
    const HalfEdgeChain chain = paths_.path_to(paths_from_.at(fresh[i].start), fresh[i].end);
    if (!chain.empty() && length_of(chart_.mesh, chain) <= longest_)
      energies[i] = coarse_.energy_when_cut(cut_along(chart_.mesh, chain), stop_);
  });
  for (std::size_t i = 0; i < fresh.size(); ++i) energies_[fresh[i]] = energies[i];
}

/// Moves the ends of a cut step by step to the best neighboring cut, until no neighboring cut is clearly better.
RankedCut CutSearch::improve(RankedCut cut) {
  while (true) {
    const std::vector<CutEnds> neighbors = neighbors_of(chart_, paths_, cut.ends);
    try_all(neighbors);
    RankedCut best = cut;
    for (const CutEnds& ends : neighbors) {
      if (energies_.at(ends) < best.energy) best = {ends, energies_.at(ends)};
    }
    if (best.energy > (1 - kLeastStep) * cut.energy) return best;
    cut = best;
  }
}

std::vector<RankedCut> CutSearch::ranked() const {
  std::vector<RankedCut> cuts;
  for (const auto& [ends, energy] : energies_) {
    if (std::isfinite(energy)) cuts.push_back({ends, energy});
  }
  std::stable_sort(cuts.begin(), cuts.end(),
                   [](const RankedCut& a, const RankedCut& b) { return a.energy < b.energy; });
  return cuts;
}

}  // namespace

std::vector<RankedCut> rank_cuts(const Chart& chart, const SmoothPathFinder& paths,
                                 const std::vector<CutEnds>& candidates, const InternalOptions& options,
                                 const CutLimits& limits, const StopToken& stop) {
  CutSearch search(chart, paths, options, limits.longest, stop);
  search.try_all(candidates);
  std::vector<RankedCut> best;
  const auto is_beside_best = [&](const RankedCut& cut) {
    return std::any_of(best.begin(), best.end(),
                       [&](const RankedCut& b) { return are_beside(chart.mesh, paths.size(), b.ends, cut.ends); });
  };
  for (const RankedCut& cut : search.ranked()) {
    if (static_cast<int>(best.size()) == limits.places || cut.energy >= search.energy_uncut()) break;
    if (is_beside_best(cut)) continue;
    const RankedCut improved = search.improve(cut);
    if (!is_beside_best(improved)) best.push_back(improved);
  }
  const double count = limits.share * static_cast<double>(search.num_tried());
  for (const RankedCut& cut : search.ranked()) {
    if (static_cast<double>(best.size()) >= count || cut.energy >= search.energy_uncut()) break;
    const auto has_same_ends = [&](const RankedCut& b) { return b.ends == cut.ends; };
    if (std::none_of(best.begin(), best.end(), has_same_ends)) best.push_back(cut);
  }
  std::stable_sort(best.begin(), best.end(),
                   [](const RankedCut& a, const RankedCut& b) { return a.energy < b.energy; });
  return best;
}

}  // namespace wirewarp
