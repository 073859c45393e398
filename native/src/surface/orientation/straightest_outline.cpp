// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/orientation/straightest_outline.h"

#include <cmath>
#include <set>
#include <vector>

#include "base/planar.h"

namespace wirewarp {
namespace {

// Largest angle between two sides of a straight run. An arc with this angle bows by only 1% of its length.
constexpr double kStraight = 5 * kPi / 180;

// Relative difference up to which lengths count as equal, so that rounding errors do not choose between the sides of a
// symmetric piece.
constexpr double kSameLength = 1e-6;

double turning(const Eigen::Vector2d& before, const Eigen::Vector2d& after) {
  return std::atan2(cross(before, after), before.dot(after));
}

/// Returns the chord of the longest straight run of a closed polygon with these sides.
Eigen::Vector2d longest_straight_run(const std::vector<Eigen::Vector2d>& sides) {
  const std::size_t n = sides.size();
  Eigen::Vector2d best(0, 0);
  Eigen::Vector2d chord(0, 0);
  std::vector<double> headings{0};  // accumulated, so that a full turn changes the heading
  std::multiset<double> in_run;
  std::size_t first = 0;
  for (std::size_t i = 0; i < 2 * n; ++i) {  // twice around, because a run may pass the first side
    if (i > 0) headings.push_back(headings.back() + turning(sides[(i - 1) % n], sides[i % n]));
    in_run.insert(headings[i]);
    chord += sides[i % n];
    while (*in_run.rbegin() - *in_run.begin() > kStraight || in_run.size() > n) {
      in_run.erase(in_run.find(headings[first]));
      chord -= sides[first++ % n];
    }
    if (chord.norm() > best.norm() * (1 + kSameLength)) best = chord;
  }
  return best;
}

}  // namespace

Eigen::Vector2d straightest_outline(const Chart& chart, const Positions2& uv) {
  Eigen::Vector2d best(0, 0);
  for (const HalfEdgeChain& loop : chart.boundary_loops) {
    std::vector<Eigen::Vector2d> sides;
    for (const HalfedgeHandle h : loop) {
      sides.emplace_back(uv.row(chart.mesh.to_vertex_handle(h).idx()) - uv.row(chart.mesh.from_vertex_handle(h).idx()));
    }
    const Eigen::Vector2d run = longest_straight_run(sides);
    if (run.norm() > best.norm() * (1 + kSameLength)) best = run;
  }
  return best;
}

}  // namespace wirewarp
