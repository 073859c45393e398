// SPDX-License-Identifier: GPL-3.0-or-later
// Removes seams that a user or another tool has made, and that the model does not need.
#include <algorithm>
#include <deque>
#include <functional>
#include <set>
#include <utility>
#include <vector>

#include "base/arguments.h"
#include "base/sentence.h"
#include "cuts/propose/canonical_order.h"
#include "cuts/propose/cut_chains.h"
#include "cuts/propose/cut_progress.h"
#include "cuts/propose/line_evaluation.h"
#include "cuts/propose/merge_sections.h"
#include "cuts/propose/mirror_image.h"
#include "surface/charts/cut_into_charts.h"
#include "surface/mesh/edge_table.h"
#include "wirewarp/propose.h"

namespace wirewarp {
namespace {

/// Progress (0 to 1) when the input is flattened with all its seams. Rough, because it only affects the bar.
constexpr double kFlattened = 0.1;

/// A part of the model between the seams that must stay, in canonical order.
struct Part {
  Part(const Chart& given, const VertexPairs& seams, const StopToken& stop)
      : chart(in_canonical_order(given, stop)),
        mirrored(chart, mirror_image(chart, stop)),
        cut(PartMap(chart).mask_of(as_list(seams))) {}

  std::vector<VertexPair> edges() const { return edges_by_section(chart, cut); }

  const Chart chart;
  const MirroredCuts mirrored;
  CutMask cut;  // the removable seams that are left
};

class SeamSimplifier {
 public:
  SeamSimplifier(double strain, const ExactEvaluation& exact, CutProgress& progress)
      : input_(exact.surface().middle()),
        edges_(input_.faces, static_cast<int>(input_.vertices.rows())),
        strain_(strain),
        exact_(exact),
        progress_(progress) {}

  /// Returns the seams that remain, with their figures. Throws Stopped if canceled before there is a result.
  SeamProposal find() {
    progress_.enter(0, kFlattened);
    pieces_ = exact_.uncut();
    const std::vector<VertexPair> seams = list_seams();
    SeamProposal proposal;
    const PieceFigures before = figures_of(pieces_);
    proposal.length_before = length_of(seams);
    proposal.num_pieces_before = before.num_pieces;
    proposal.energy_before = before.energy;
    proposal.strain_before = before.strain;
    proposal.was_stopped = was_stopped([&] { merge(); });
    const PieceFigures after = figures_of(pieces_);
    proposal.num_pieces = after.num_pieces;
    proposal.energy = after.energy;
    proposal.strain = after.strain;
    for (const Part& part : parts_) {
      for (const VertexPair& ends : part.edges()) proposal.edges.push_back(ends);
    }
    const std::set<VertexPair> listed = undirected(proposal.edges);
    for (const VertexPair& ends : seams) {
      if (listed.count(sorted(ends)) != 0) continue;
      (opened_.count(sorted(ends)) != 0 ? proposal.opened : proposal.edges).push_back(ends);
    }
    proposal.length = length_of(proposal.edges);
    return proposal;
  }

 private:
  /// Returns all edges that are seams, without duplicates. Adds to kept_ the seams that must stay.
  std::vector<VertexPair> list_seams() {
    std::set<VertexPair> eased, known;
    for (const Ease& ease : input_.eases) eased.merge(undirected(as_list(ease.half_edges)));
    std::vector<VertexPair> seams;
    for (const VertexPair& ends : as_list(input_.seams)) {
      const int sides = edges_.num_sides(edges_.find(ends[0], ends[1]));
      if (sides < 2 || !known.insert(sorted(ends)).second) continue;
      seams.push_back(ends);
      if (sides > 2 || eased.count(sorted(ends)) != 0) kept_.push_back(ends);
    }
    return seams;
  }

  double length_of(const std::vector<VertexPair>& edges) const {
    double length = 0;
    for (const auto& [from, to] : edges) length += (input_.vertices.row(from) - input_.vertices.row(to)).norm();
    return length;
  }

  /// Removes seams from all parts. Throws Stopped. Seams that were removed by then stay removed.
  void merge() {
    FlattenInput undivided = input_;
    undivided.seams = as_pairs(kept_);
    double total = 0, done = 0;
    for (const Chart& chart : cut_into_charts(undivided, edges_, exact_.stop()).charts) {
      if (chart.mesh.n_faces() > 0) parts_.emplace_back(chart, input_.seams, exact_.stop());
    }
    for (const Part& part : parts_) total += length_of_cut(part.chart.mesh, part.cut);
    for (Part& part : parts_) {
      const double length = length_of_cut(part.chart.mesh, part.cut);
      merge(part,
            [&](double share) { progress_.stay_at(kFlattened + (1 - kFlattened) * (done + share * length) / total); });
      done += length;
    }
  }

  void merge(Part& part, const std::function<void(double)>& report) {
    const std::vector<VertexPair> before = part.edges();
    SectionMerger merger({part.cut, pieces_}, part.chart, part.mirrored, exact_);
    const bool stopped = was_stopped([&] { merger.run(strain_, report); });
    part.cut = merger.state().cut;
    pieces_ = merger.state().pieces;
    for (const VertexPair& ends : before) opened_.insert(sorted(ends));
    for (const VertexPair& ends : part.edges()) opened_.erase(sorted(ends));
    if (stopped) throw Stopped();
  }

  const FlattenInput& input_;
  const EdgeTable edges_;
  const double strain_;
  const ExactEvaluation& exact_;
  CutProgress& progress_;
  FlatPieces pieces_;
  std::vector<VertexPair> kept_;
  std::deque<Part> parts_;
  std::set<VertexPair> opened_;
};

}  // namespace

SeamProposal simplify_seams(const FlattenInput& input, const Options& options, double strain,
                            const Progress& progress) {
  if (!(strain >= 0)) throw wrong_option("strain", shortest(strain), "be 0 or more");
  CutProgress cut_progress(progress);
  SeamProposal proposal = search_cuts(input, options, cut_progress.token(), [&](const ExactEvaluation& exact) {
    return SeamSimplifier(strain, exact, cut_progress).find();
  });
  proposal.paths = paths_along(input.faces, proposal.edges);
  return proposal;
}

}  // namespace wirewarp
