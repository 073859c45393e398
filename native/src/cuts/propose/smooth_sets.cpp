// SPDX-License-Identifier: GPL-3.0-or-later
#include "cuts/propose/smooth_sets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "base/planar.h"
#include "base/work_meter.h"
#include "cuts/feasibility/mirrored_cuts.h"
#include "cuts/propose/canonical_order.h"
#include "cuts/propose/flat_width.h"
#include "cuts/propose/line_bends.h"
#include "cuts/propose/line_evaluation.h"
#include "cuts/propose/mirror_image.h"
#include "cuts/propose/relax_lines.h"
#include "cuts/propose/symmetric_paths.h"
#include "surface/mesh/geometry.h"

namespace wirewarp {
namespace {

/// At the highest level, lines are smoothed over kEdges edge lengths or kOfSize √area, whichever is longer. Each lower
/// level halves this distance. Zigzags need one or two edge lengths, larger bends more. On a front of 30 by 40 cm,
/// kOfSize is 14 mm. The lowest of kLevels levels is half an edge length, less than any zigzag needs.
constexpr double kEdges = 4, kOfSize = 0.04;
constexpr int kLevels = 4;

/// The value of SmoothLimits::far_too_much for sets along edges. The lines of such sets need many changes of level, so
/// evaluations must be saved. With 1.05, the lines of an egg are not smooth; with 1.2, no test of smooth sets changes.
constexpr double kFarTooMuch = 1.1;

/// A smooth set may have at most this share of the bends of the set along edges. With more bends, the additional strain
/// is not worthwhile: with 1, a chess bishop gets one more smooth set, with 4% more strain. With 0.25, the lines of an
/// egg and a dart are not smooth.
constexpr double kMostBends = 0.5;

/// A smooth set may have this many times the strain of the set along edges. Zigzags are longer and pass through more
/// vertices, which have all curvature of a coarse mesh. Therefore, zigzags need less strain. With 1, five tests get no
/// smooth set; with 4, no test of smooth sets changes.
constexpr double kMostGrowth = 2;

/// Returns the number of vertices minus the number of edges, and the number of free ends. If lines newly meet or
/// separate, one of these numbers changes.
std::array<int, 2> count_ends(const std::vector<VertexPair>& edges) {
  std::map<int, int> count;
  for (const VertexPair& edge : edges) {
    for (const int v : edge) ++count[v];
  }
  int num_ends = 0;
  for (const auto& each : count) num_ends += each.second == 1 ? 1 : 0;
  return {static_cast<int>(count.size()) - static_cast<int>(edges.size()), num_ends};
}

template <typename Number>
bool is_any(const std::vector<Number>& numbers) {
  return std::any_of(numbers.begin(), numbers.end(), [](Number each) { return each != 0; });
}

class SmoothSet {
 public:
  SmoothSet(const DartProposal& set, const SurfaceLines& lines, const SmoothLimits& limits, const PieceToCut& piece,
            const CutOptions& cut_options, const ExactEvaluation& exact)
      : set_(set),
        limits_(limits),
        given_(exact.surface().given()),
        piece_(piece),
        chart_(piece.chart),
        cut_options_(cut_options),
        exact_(exact),
        barriers_(barriers()),
        images_(lines.images),
        is_symmetric_(lines.is_symmetric),
        mirror_(given_, chart_, piece.image),
        network_(chart_.mesh, lines.lines, barriers_),
        start_(paths_of(given_, chart_, lines)),
        levels_(lines.lines.size(), 0),
        highest_(lines.lines.size(), kLevels) {
    for (const SurfaceLine& line : lines.lines) ends_.push_back({line.first, line.last});
    num_bends_before_ = num_bends(cut_mesh(given_.vertices, given_.faces, start_));
    num_ends_before_ = count_ends(ends_);
  }

  std::optional<DartProposal> find() {
    while (true) {
      const std::vector<SurfacePath> paths = smooth_enough();
      const CutMesh cut = cut_mesh(given_.vertices, given_.faces, paths);
      if (!is_any(levels_) || num_bends(cut) > limits_.most_bends * num_bends_before_) return std::nullopt;
      if (std::optional<DartProposal> smooth = evaluate(paths, cut)) return smooth;
    }
  }

 private:
  CutMask barriers() const;
  int num_bends(const CutMesh& cut) const;
  std::vector<SurfacePath> lines();
  SurfacePath path_along(const RelaxedLine& line) const;
  std::vector<SurfacePath> smooth_enough();
  std::optional<DartProposal> evaluate(const std::vector<SurfacePath>& paths, const CutMesh& cut);
  void lower(std::vector<char> chosen);
  std::vector<char> beside_failures(const CutMesh& cut, const FlatPieces& after, const Chart& chart) const;
  std::vector<char> beside(const FlatPiece& part, const CutMesh& cut) const;
  std::vector<char> most_strained(const FlatPiece& part, const CutMesh& cut, const std::vector<char>& lines) const;
  std::vector<char> that_touch(const CutMesh& cut) const;

  const DartProposal& set_;
  const SmoothLimits limits_;
  const FlattenInput& given_;
  const PieceToCut& piece_;
  const Chart& chart_;
  const CutOptions& cut_options_;
  const ExactEvaluation& exact_;
  const CutMask barriers_;
  const std::vector<std::size_t>& images_;  // mirror image of each line
  const bool is_symmetric_;                 // whether each line has a mirror image
  const PathMirror mirror_;
  const LineNetwork network_;
  const std::vector<SurfacePath> start_;  // lines before smoothing
  std::vector<VertexPair> ends_;          // per line: numbers of both ends
  int num_bends_before_ = 0;
  std::array<int, 2> num_ends_before_{};
  std::vector<int> levels_;   // per line: level of smoothness; 0: not smoothed
  std::vector<int> highest_;  // per line: highest level that may be tried
};

/// Returns the edges that lines must not cross: wires, and edges that cuts must avoid, with their mirror images.
CutMask SmoothSet::barriers() const {
  const PartMap map(chart_);
  CutMask mask = map.mask_of(as_list(cut_options_.no_crossing));
  unite(mask, map.mask_of(as_list(cut_options_.no_seam)));
  for (const Wire& wire : given_.wires) {
    std::vector<VertexPair> edges;
    for (std::size_t i = 1; i < wire.vertices.size(); ++i) edges.push_back({wire.vertices[i - 1], wire.vertices[i]});
    unite(mask, map.mask_of(edges));
  }
  return MirroredCuts(chart_, piece_.image).with_image(mask);
}

int SmoothSet::num_bends(const CutMesh& cut) const {
  const std::vector<int> bends = count_bends(cut, levels_.size());
  return std::accumulate(bends.begin(), bends.end(), 0);
}

/// Permanently lowers the levels of the chosen lines and of their mirror images. If all have level 0, lowers the lines
/// that meet them instead, and so on, because lines move their neighbors.
void SmoothSet::lower(std::vector<char> chosen) {
  while (is_any(levels_)) {
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      if (chosen[i] != 0) chosen[images_[i]] = 1;
    }
    bool is_lower = false;
    for (std::size_t i = 0; i < levels_.size(); ++i) {
      if (chosen[i] == 0 || levels_[i] == 0) continue;
      highest_[i] = --levels_[i];
      is_lower = true;
    }
    if (is_lower) return;
    const std::vector<char> before = chosen;
    std::set<int> ends;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      if (chosen[i] != 0) ends.insert({ends_[i][0], ends_[i][1]});
    }
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      if (ends.count(ends_[i][0]) + ends.count(ends_[i][1]) != 0) chosen[i] = 1;
    }
    if (chosen == before) chosen.assign(chosen.size(), 1);
  }
}

SurfacePath SmoothSet::path_along(const RelaxedLine& line) const {
  std::vector<WeightedPoint> points;
  const auto add_end = [&](const SurfacePoint& end) {
    if (!line.is_closed && !end.vertex.is_valid()) points.push_back(on_input(given_, chart_, end.face, end.place));
  };
  add_end(line.start);
  for (const PathPoint& point : line.between) points.push_back(on_input(given_, chart_, point));
  add_end(line.end);
  return path_through(points);
}

/// Returns the lines at their levels. Lowers the levels of lines that cannot be relaxed at their level.
std::vector<SurfacePath> SmoothSet::lines() {
  const double most = std::max(kEdges * network_.mean_edge(), kOfSize * std::sqrt(surface_area(chart_.mesh)));
  while (true) {
    std::vector<int> steps;
    for (const int level : levels_)
      steps.push_back(level == 0 ? 0 : network_.steps_for(most * std::pow(0.5, kLevels - level)));
    const std::vector<std::optional<RelaxedLine>> relaxed = network_.relax(steps, exact_.stop());
    std::vector<char> failed(levels_.size(), 0);
    std::vector<SurfacePath> lines;
    for (std::size_t i = 0; i < levels_.size(); ++i) {
      failed[i] = levels_[i] > 0 && !relaxed[i];
      if (relaxed[i]) {
        lines.push_back(path_along(*relaxed[i]));
      } else {
        lines.push_back(start_[i]);
      }
    }
    if (!is_any(failed)) {
      if (is_symmetric_) mirror_.make_symmetric(images_, lines);
      return lines;
    }
    lower(failed);
  }
}

/// Raises the levels of lines that turn sharply, and returns the lines at their levels. Lowers the levels of lines that
/// touch other lines where they did not touch before.
std::vector<SurfacePath> SmoothSet::smooth_enough() {
  while (true) {
    exact_.stop().check();
    std::vector<SurfacePath> paths = lines();
    const CutMesh cut = cut_mesh(given_.vertices, given_.faces, paths);
    if (is_any(levels_) && count_ends(cut.edges) != num_ends_before_) {
      lower(that_touch(cut));
      continue;
    }
    const std::vector<int> bends = count_bends(cut, levels_.size());
    bool is_higher = false;
    for (std::size_t i = 0; i < levels_.size(); ++i) {
      if (bends[i] + bends[images_[i]] == 0 || levels_[i] == highest_[i]) continue;
      ++levels_[i];
      is_higher = true;
    }
    if (!is_higher) return paths;
  }
}

/// Returns the lines without edges, and the lines that meet another line elsewhere than at a common end.
std::vector<char> SmoothSet::that_touch(const CutMesh& cut) const {
  const std::vector<int>& line_of = cut.sources.edge_paths;
  // Per vertex and line: above 0 if the line passes the vertex, and 0 if the line only begins or ends there.
  std::map<int, std::map<int, int>> met;
  for (std::size_t i = 0; i < cut.edges.size(); ++i) {
    const bool is_first = i == 0 || line_of[i - 1] != line_of[i];
    const bool is_last = i + 1 == cut.edges.size() || line_of[i + 1] != line_of[i];
    met[cut.edges[i][0]][line_of[i]] += is_first ? 0 : 1;
    met[cut.edges[i][1]][line_of[i]] += is_last ? 0 : 1;
  }
  std::vector<char> touch(levels_.size(), 0);
  for (const auto& [v, lines] : met) {
    const bool is_passed = std::any_of(lines.begin(), lines.end(), [](const auto& line) { return line.second > 0; });
    if (lines.size() < 2 || !is_passed) continue;
    for (const auto& line : lines) touch[static_cast<std::size_t>(line.first)] = 1;
  }
  for (std::size_t i = 0; i < touch.size(); ++i) {
    if (std::find(line_of.begin(), line_of.end(), static_cast<int>(i)) == line_of.end()) touch[i] = 1;
  }
  return touch;
}

/// Returns the lines whose levels must be lowered. They are around parts of a chart that have no flat shape, need too
/// much strain, or are too narrow.
std::vector<char> SmoothSet::beside_failures(const CutMesh& cut, const FlatPieces& after, const Chart& chart) const {
  const FlatPieces parts = parts_of(after, chart);
  const bool are_narrow = count_narrow(parts, cut_options_.narrowest) > limits_.num_narrow;
  std::vector<char> failures(levels_.size(), 0);
  for (const std::shared_ptr<const FlatPiece>& part : parts) {
    const bool has_failed =
        part->error || part->strain > limits_.most_strain || (are_narrow && is_narrow(*part, cut_options_.narrowest));
    if (!has_failed) continue;
    const std::vector<char> around = beside(*part, cut);
    const bool is_near = !part->error && part->strain > limits_.most_strain &&
                         part->strain <= limits_.far_too_much * limits_.most_strain;
    unite(failures, is_near ? most_strained(*part, cut, around) : around);
  }
  return failures;
}

std::vector<char> SmoothSet::beside(const FlatPiece& part, const CutMesh& cut) const {
  std::vector<char> lines(levels_.size(), 0);
  for (std::size_t i = 0; i < cut.edges.size(); ++i) {
    if (std::binary_search(part.outline.begin(), part.outline.end(), sorted(cut.edges[i])))
      lines[static_cast<std::size_t>(cut.sources.edge_paths[i])] = 1;
  }
  return lines;
}

/// Returns the given line that is nearest to most of the area with too much strain. Ignores lines with level 0. If this
/// leaves no line, returns all given lines.
std::vector<char> SmoothSet::most_strained(const FlatPiece& part, const CutMesh& cut,
                                           const std::vector<char>& lines) const {
  std::vector<std::pair<std::size_t, Eigen::RowVector3d>> middles;  // per edge of a line above level 0: line, midpoint
  for (std::size_t i = 0; i < cut.edges.size(); ++i) {
    const auto line = static_cast<std::size_t>(cut.sources.edge_paths[i]);
    const auto& [a, b] = cut.edges[i];
    if (lines[line] != 0 && levels_[line] != 0)
      middles.emplace_back(line, (cut.vertices.row(a) + cut.vertices.row(b)) / 2);
  }
  WorkMeter work(exact_.stop());
  std::vector<double> area(levels_.size(), 0);
  const HalfEdgeMesh& mesh = part.chart.mesh;
  for (const FaceHandle f : mesh.faces()) {
    if (part.face_strain[f.idx()] <= limits_.most_strain) continue;
    const Eigen::RowVector3d center = vector_of(mesh.calc_face_centroid(f)).transpose();
    double least = std::numeric_limits<double>::infinity();
    std::size_t nearest = levels_.size();
    work.did(middles.size());
    for (const auto& [line, place] : middles) {
      const double distance = (center - place).squaredNorm();
      if (distance >= least) continue;
      least = distance;
      nearest = line;
    }
    if (nearest < area.size()) area[nearest] += face_area(mesh, f);
  }
  const auto most = std::max_element(area.begin(), area.end());
  if (*most == 0) return lines;
  std::vector<char> chosen(levels_.size(), 0);
  chosen[static_cast<std::size_t>(most - area.begin())] = 1;
  return chosen;
}

/// Returns the set along the lines `paths`. If the set exceeds the limits, divides the piece differently or spoils
/// other pieces, lowers some levels and returns nullopt.
std::optional<DartProposal> SmoothSet::evaluate(const std::vector<SurfacePath>& paths, const CutMesh& cut) {
  const CutSurface surface(piece_.pieces, piece_.index, exact_, cut);
  const FlatPieces &before = surface.before(), &after = surface.after();
  const Chart& chart = surface.chart();
  const PieceFigures figures = figures_of(after, chart);
  const std::vector<char> failures = beside_failures(cut, after, chart);
  const bool is_divided_alike = !figures.error && figures.num_pieces == set_.num_pieces;
  if (is_any(failures) || !is_divided_alike || spoils_others(before, after, chart)) {
    lower(failures);
    return std::nullopt;
  }
  return with_lines(set_, paths, surface, figures);
}

}  // namespace

std::optional<DartProposal> smooth_lines(const DartProposal& set, const SurfaceLines& lines, const SmoothLimits& limits,
                                         const PieceToCut& piece, const CutOptions& cut_options,
                                         const ExactEvaluation& exact) {
  return SmoothSet(set, lines, limits, piece, cut_options, exact).find();
}

DartProposal smooth_set(const DartProposal& set, double most_strain, const FlatPieces& pieces, std::size_t piece,
                        const CutOptions& cut_options, const ExactEvaluation& exact) {
  const Chart chart = in_canonical_order(pieces[piece]->chart, exact.stop());
  const std::vector<VertexHandle> image = mirror_image(chart, exact.stop());
  const SurfaceLines lines = lines_along(chart, image, PartMap(chart).mask_of(set.edges));
  SmoothLimits limits{std::min(most_strain, kMostGrowth * set.strain + kStrainError), kMostBends};
  limits.far_too_much = kFarTooMuch;
  if (cut_options.narrowest > 0)
    limits.num_narrow =
        count_narrow(parts_of(exact.with_cut(pieces, set.edges), pieces[piece]->chart), cut_options.narrowest);
  return smooth_lines(set, lines, limits, {pieces, piece, chart, image}, cut_options, exact).value_or(set);
}

}  // namespace wirewarp
