// SPDX-License-Identifier: GPL-3.0-or-later
#include "cuts/parts/necks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "cuts/feasibility/ranks.h"
#include "cuts/parts/crease_lines.h"
#include "cuts/parts/level_lines.h"
#include "surface/mesh/geodesic_distance.h"
#include "surface/mesh/geometry.h"

namespace wirewarp {
namespace {

/// Number of points on the surface from which average_distance() averages the distances of each vertex. With 40, the
/// average has an error of about 1%, which is less than its difference between a tip and the surroundings.
constexpr std::size_t kSamples = 40;

/// Shares of √area. The ears of a bear of 30 cm are 0.24 apart: twice kAroundTip, and four times kBetweenTips. So both
/// are tips.
/// - kAroundTip: radius in which no vertex has a larger average distance than the tip
/// - kBetweenTips: least distance between two tips
constexpr double kAroundTip = 0.12, kBetweenTips = 0.06;

/// Largest number of tips. A figure with ten fingers has fewer.
constexpr std::size_t kMostTips = 24;

/// kLevels: number of distances from a tip at which L / √A (see necks.h) is measured. At a neck, L / √A has its least
/// value among kAround of these distances on each side. These are 5% of the greatest distance, so narrower dips are
/// ignored.
constexpr int kLevels = 120, kAround = 6;

/// Least and largest area of the part at a tip, as a share of the surface's area. A bear's ear has the share 0.024, and
/// its head 0.4.
constexpr double kSmallest = 0.006, kLargest = 0.55;

/// Largest L / √A of a neck. For parts with more than the share kLarge of the area, kShortIfLarge replaces kShort.
/// - Small parts: bear's ears 2.27, star's arms 2
/// - Large parts: bear's head 1.16, rabbit's head 1.46, but 2.3 at a star's middle, which is not a neck
constexpr double kShort = 2.4, kShortIfLarge = 1.5, kLarge = 0.25;

/// Beyond a neck, L grows by the factor kWidens before the area of the part at the tip grows by the factor kSoon. This
/// excludes cylinders, where L is constant, but not cones, where L grows by 1.34 while the area grows by 1.8.
constexpr double kWidens = 1.12, kSoon = 1.8;

/// Relation of two parts by their common area:
/// - the same: above the share kSame of their union; two necks so near each other would leave a thin ring
/// - nested: above the share kNested of the smaller part
/// - disjoint: below the share kDisjoint of the smaller part
/// kNested and kDisjoint allow 3% for faces at the loops, which are inside or outside as a whole. With 0.3 or 0.9 as
/// kSame, six toys have the same sets.
constexpr double kSame = 0.6, kNested = 0.97, kDisjoint = 0.03;

/// Two parts have the same neck if more than this share of the surface is in exactly one of them. The neck then
/// separates one part from the other. Without this limit, a neck is found from both sides. With half of it, no test of
/// parts changes.
constexpr double kWhole = 0.75;

/// Distances that differ by less than this share are equal except for rounding errors.
constexpr double kRounding = 1e-9;

/// Potential along a crease: the mean of the potentials at the ends of the band, 0 and 1.
constexpr double kCrease = 0.5;

using Distances = Eigen::VectorXd;

int first_of_largest(const Eigen::VectorXd& values) {
  const double least = (1 - kRounding) * values.maxCoeff();
  return static_cast<int>(std::find_if(values.begin(), values.end(), [&](double value) { return value >= least; }) -
                          values.begin());
}

class NeckSearch {
 public:
  NeckSearch(const HalfEdgeMesh& mesh, const std::vector<VertexHandle>& image, const StopToken& stop)
      : mesh_(mesh), image_(image), stop_(stop), geodesic_(mesh, stop), areas_(mesh.n_faces()) {
    for (const FaceHandle f : mesh.faces()) areas_[f.idx()] = face_area(mesh, f);
    area_ = areas_.sum();
  }

  std::vector<Neck> find() {
    std::vector<Candidate> found;
    for (const Distances& distance : distances_from_tips()) {
      stop_.check();
      add_candidates(distance, found);
    }
    std::vector<double> narrowness, areas;
    for (const Candidate& candidate : found) narrowness.push_back(-candidate.ratio);
    for (const std::size_t i : highest_first(narrowness, kRounding)) {
      stop_.check();
      if (!accept(in_crease(found[i]))) accept(found[i]);
    }
    for (const Candidate& candidate : accepted_) areas.push_back(area_of(candidate.is_inside));
    std::vector<Neck> necks;
    for (const std::size_t i : highest_first(areas, kRounding * area_)) necks.push_back(std::move(accepted_[i].neck));
    return necks;
  }

 private:
  using Faces = Eigen::VectorXd;  // per face: 1 if the face is in the part at the tip, otherwise 0

  struct Candidate {
    double ratio;  // L / √A
    Neck neck;
    Faces is_inside;
  };

  Distances mirrored(const Distances& values) const {
    Distances result(values.size());
    for (Eigen::Index v = 0; v < values.size(); ++v) result[v] = values[image_[static_cast<std::size_t>(v)].idx()];
    return result;
  }

  /// Returns the mean distance of each vertex from sample points on the surface. Each sample is weighted by the area
  /// around it.
  Distances average_distance() const;
  std::vector<Distances> distances_from_tips() const;
  void add_candidates(const Distances& distance, std::vector<Candidate>& found) const;
  Candidate in_crease(const Candidate& candidate) const;
  bool accept(const Candidate& candidate);
  bool fits(const Faces& one, const Faces& other) const;
  Eigen::VectorXd of_faces(const Distances& distance) const;
  Faces within(const Distances& distance, double level) const {
    return (of_faces(distance).array() < level).cast<double>();
  }
  double area_of(const Faces& faces) const { return areas_.dot(faces); }
  double common_area(const Faces& a, const Faces& b) const { return areas_.dot(a.cwiseProduct(b)); }

  const HalfEdgeMesh& mesh_;
  const std::vector<VertexHandle>& image_;
  const StopToken& stop_;
  const GeodesicDistance geodesic_;
  Eigen::VectorXd areas_;  // per face
  double area_ = 0;
  std::vector<Candidate> accepted_;
};

Distances NeckSearch::average_distance() const {
  const Positions3 points = points_of(mesh_);
  const Eigen::RowVector3d center = points.colwise().mean();
  const int first = first_of_largest((points.rowwise() - center).rowwise().norm());
  std::vector<Distances> from{geodesic_.from(VertexHandle(first))};
  Distances nearest = from.front();
  std::vector<std::size_t> sample_of(mesh_.n_vertices(), 0);
  while (from.size() < std::min<std::size_t>(kSamples, mesh_.n_vertices())) {
    stop_.check();
    from.push_back(geodesic_.from(VertexHandle(first_of_largest(nearest))));
    for (std::size_t v = 0; v < sample_of.size(); ++v) {
      const auto row = static_cast<Eigen::Index>(v);
      if (from.back()[row] >= nearest[row]) continue;
      nearest[row] = from.back()[row];
      sample_of[v] = from.size() - 1;
    }
  }
  Distances average = Distances::Zero(nearest.size());
  for (const FaceHandle f : mesh_.faces()) {
    for (const VertexHandle v : mesh_.fv_range(f)) average += areas_[f.idx()] / 3 * from[sample_of[v.idx()]];
  }
  average /= area_;
  return image_.empty() ? average : Distances((average + mirrored(average)) / 2);
}

/// Returns the distances of all vertices from each tip, but only from one tip of each mirrored pair. The distances from
/// a tip in or near the mirror plane are symmetric.
std::vector<Distances> NeckSearch::distances_from_tips() const {
  const Distances average = average_distance();
  const double size = std::sqrt(area_);
  const std::vector<int> ranks = ranks_of({average.begin(), average.end()}, kRounding * size);
  std::vector<int> order(mesh_.n_vertices());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return ranks[a] > ranks[b]; });
  std::vector<char> is_taken(mesh_.n_vertices(), 0);
  std::vector<Distances> tips;
  for (const int v : order) {
    if (tips.size() == kMostTips) break;
    if (is_taken[v] != 0) continue;
    stop_.check();
    Distances distance = geodesic_.from(VertexHandle(v));
    bool is_tip = true;
    for (Eigen::Index w = 0; w < distance.size(); ++w) {
      if (distance[w] < kAroundTip * size && ranks[w] > ranks[v]) is_tip = false;
      if (distance[w] >= kBetweenTips * size) continue;
      is_taken[w] = 1;
      if (!image_.empty()) is_taken[image_[static_cast<std::size_t>(w)].idx()] = 1;
    }
    if (!is_tip) continue;
    if (!image_.empty() && distance[image_[v].idx()] < kAroundTip * size)
      distance = (distance + mirrored(distance)) / 2;
    tips.push_back(std::move(distance));
  }
  return tips;
}

Eigen::VectorXd NeckSearch::of_faces(const Distances& distance) const {
  Eigen::VectorXd means = Eigen::VectorXd::Zero(areas_.size());
  for (const FaceHandle f : mesh_.faces()) {
    for (const VertexHandle v : mesh_.fv_range(f)) means[f.idx()] += distance[v.idx()] / 3;
  }
  return means;
}

/// Adds a candidate for each neck around a tip. distance: distance of each vertex from the tip.
void NeckSearch::add_candidates(const Distances& distance, std::vector<Candidate>& found) const {
  const double farthest = distance.maxCoeff(), first = kBetweenTips * std::sqrt(area_);
  const Eigen::VectorXd face_distance = of_faces(distance);
  std::vector<double> levels, areas, lengths, ratios;
  for (int i = 0; i < kLevels; ++i) {
    const double level = first + (farthest - first) * i / kLevels;
    const double area = (face_distance.array() < level).select(areas_, 0).sum();
    levels.push_back(level);
    areas.push_back(area);
    lengths.push_back(level_length(mesh_, distance, level));
    const double least = std::min(area, area_ - area);
    ratios.push_back(least > 0 ? lengths.back() / std::sqrt(least) : std::numeric_limits<double>::infinity());
  }
  for (int i = 0; i < kLevels; ++i) {
    const double most = areas[i] > kLarge * area_ ? kShortIfLarge : kShort;
    if (areas[i] < kSmallest * area_ || areas[i] > kLargest * area_ || ratios[i] > most) continue;
    const auto begin = ratios.begin() + std::max(i - kAround, 0),
               end = ratios.begin() + std::min(i + kAround + 1, kLevels);
    if (ratios[i] > *std::min_element(begin, end)) continue;
    bool widens = false;
    for (int k = i + 1; k < kLevels && areas[k] < kSoon * areas[i]; ++k)
      widens = widens || lengths[k] >= kWidens * lengths[i];
    if (widens) found.push_back({ratios[i], {distance, levels[i]}, within(distance, levels[i])});
  }
}

bool NeckSearch::fits(const Faces& one, const Faces& other) const {
  const double both = common_area(one, other), a = area_of(one), b = area_of(other), least = std::min(a, b);
  if (both > kSame * (a + b - both) || a + b - 2 * both > kWhole * area_) return false;
  return both > kNested * least || both < kDisjoint * least;
}

/// Returns the candidate with its loop in the nearest crease, or unchanged if the loop would be longer there.
NeckSearch::Candidate NeckSearch::in_crease(const Candidate& candidate) const {
  const auto& [distance, level] = candidate.neck;
  const double length = level_length(mesh_, distance, level);
  Candidate moved{candidate.ratio, {potential_across(mesh_, distance, level, length), kCrease}, {}};
  const double moved_length = level_length(mesh_, moved.neck.distance, kCrease);
  if (!(moved_length > 0 && moved_length <= length)) return candidate;
  moved.is_inside = within(moved.neck.distance, kCrease);
  return moved;
}

/// Accepts a neck, together with its mirror image, if both fit each other and all accepted necks. Returns whether they
/// fit.
bool NeckSearch::accept(const Candidate& candidate) {
  std::vector<Candidate> added{candidate};
  if (!image_.empty()) {
    Candidate other{candidate.ratio, {mirrored(candidate.neck.distance), candidate.neck.level}, {}};
    other.is_inside = within(other.neck.distance, other.neck.level);
    const double both = common_area(candidate.is_inside, other.is_inside), own = area_of(candidate.is_inside);
    if (both >= kDisjoint * own && both <= kNested * own) return false;
    if (both < kDisjoint * own) {
      added.push_back(std::move(other));
    } else {
      added.front().neck.distance = (candidate.neck.distance + other.neck.distance) / 2;
    }
  }
  for (const Candidate& known : accepted_) {
    for (const Candidate& each : added) {
      if (!fits(each.is_inside, known.is_inside)) return false;
    }
  }
  std::move(added.begin(), added.end(), std::back_inserter(accepted_));
  return true;
}

}  // namespace

std::vector<Neck> find_necks(const HalfEdgeMesh& mesh, const std::vector<VertexHandle>& image, const StopToken& stop) {
  return NeckSearch(mesh, image, stop).find();
}

}  // namespace wirewarp
