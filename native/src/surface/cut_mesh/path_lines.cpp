// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/cut_mesh/path_lines.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

#include "base/arguments.h"

namespace wirewarp {
namespace {

/// A line passes through a site, or crosses a line there, if the site is nearer than this share of `snap`. With one
/// half, the nearest site is unique, because sites are `snap` apart.
constexpr double kCloseBy = 0.5;

/// Maximum number of divisions in one face. Sites are `snap` apart, so even dense scribbles need far fewer.
constexpr int kMostDivisions = 10000;

/// Returns the distance of two points: the largest difference of their three barycentric coordinates.
double distance(const FacePoint& a, const FacePoint& b) {
  const FacePoint apart = b - a;
  return std::max(apart.cwiseAbs().maxCoeff(), std::abs(apart.sum()));
}

/// Returns the position on the line through a and b that is nearest to another point: 0 is a, 1 is b.
double nearest_on(const FacePoint& a, const FacePoint& b, const FacePoint& other) {
  return (other - a).dot(b - a) / (b - a).squaredNorm();
}

FacePoint between(const FacePoint& a, const FacePoint& b, double t) { return a + t * (b - a); }

}  // namespace

void PathLines::draw(int face, int from, int to) {
  if (from == to || sites_.common_edge(from, to) >= 0) return;
  const Line line{std::min(from, to), std::max(from, to)};
  const auto known = divided_.find(line);
  if (known == divided_.end()) {
    lines_[face].insert(line);
    return;
  }
  draw(face, from, known->second);
  draw(face, known->second, to);
}

void PathLines::divide_at(int face, Line line, int site) {
  lines_[face].erase(line);
  divided_[line] = site;
  draw(face, line[0], site);
  draw(face, site, line[1]);
}

/// Returns whether a site may divide a line: both parts must be shorter than the line, so that the division terminates.
bool PathLines::is_between(int face, int site, const Line& line) const {
  const FacePoint a = point(face, line[0]), b = point(face, line[1]), c = point(face, site);
  return std::max((c - a).norm(), (b - c).norm()) < (b - a).norm();
}

/// Returns a site inside a face or on its border that the line nearly passes through; -1 if there is none.
int PathLines::site_close_by(int face, const Line& line) const {
  const FacePoint a = point(face, line[0]), b = point(face, line[1]);
  for (const int site : sites_.of_face(face)) {
    if (site == line[0] || site == line[1]) continue;
    const FacePoint c = point(face, site);
    const double t = nearest_on(a, b, c);
    const bool is_near = t > 0 && t < 1 && distance(between(a, b, t), c) < kCloseBy * sites_.snap();
    if (is_near && is_between(face, site, line)) return site;
  }
  return -1;
}

/// Returns the crossing of two lines: the nearest site if a site is near, otherwise a new site.
int PathLines::crossing_of(int face, const Line& one, const Line& other) {
  const FacePoint a = point(face, one[0]), b = point(face, one[1]);
  const FacePoint c = point(face, other[0]), d = point(face, other[1]);
  const double from = doubled_area(c, d, a), to = doubled_area(c, d, b);
  const FacePoint crossing = between(a, b, from / (from - to));
  const auto may_lead = [&](int site, const Line& line) {
    return site == line[0] || site == line[1] || is_between(face, site, line);
  };
  int nearest = -1;
  double least = kCloseBy * sites_.snap();
  for (const int site : sites_.of_face(face)) {
    const double apart = distance(point(face, site), crossing);
    if (apart >= least || !may_lead(site, one) || !may_lead(site, other)) continue;
    nearest = site;
    least = apart;
  }
  if (nearest >= 0) return nearest;
  return sites_.add_inside(face, {1 - crossing[0] - crossing[1], crossing[0], crossing[1]});
}

/// Divides a line of a face at a site or crossing. Returns false if no line needs a division.
bool PathLines::divide_once(int face, const std::set<Line>& lines) {
  for (const Line& line : lines) {
    const int site = site_close_by(face, line);
    if (site < 0) continue;
    divide_at(face, line, site);
    return true;
  }
  for (auto first = lines.begin(); first != lines.end(); ++first) {
    const Line one = *first;
    const FacePoint a = point(face, one[0]), b = point(face, one[1]);
    for (auto second = std::next(first); second != lines.end(); ++second) {
      const Line other = *second;
      const FacePoint c = point(face, other[0]), d = point(face, other[1]);
      const bool have_common_end = one[0] == other[0] || one[0] == other[1] || one[1] == other[0] || one[1] == other[1];
      if (have_common_end || !do_cross(a, b, c, d)) continue;
      const int site = crossing_of(face, one, other);
      if (site != one[0] && site != one[1]) divide_at(face, one, site);
      if (site != other[0] && site != other[1]) divide_at(face, other, site);
      return true;
    }
  }
  return false;
}

void PathLines::divide() {
  for (const auto& [face, lines] : lines_) {
    for (int count = 0; divide_once(face, lines); ++count) {
      if (count < kMostDivisions) continue;
      throw wrong_option("paths", "a scribble in face " + std::to_string(face), "cross fewer times in one face");
    }
  }
}

void PathLines::append_sites(int from, int to, std::vector<int>& line) const {
  const int edge = sites_.common_edge(from, to);
  const auto divided = divided_.find({std::min(from, to), std::max(from, to)});
  if (edge >= 0) {
    std::vector<int> along = sites_.along(edge);
    if (std::find(along.begin(), along.end(), from) > std::find(along.begin(), along.end(), to)) {
      std::reverse(along.begin(), along.end());
    }
    const auto begin = std::find(along.begin(), along.end(), from), end = std::find(begin, along.end(), to);
    line.insert(line.end(), begin + 1, end + 1);
  } else if (divided != divided_.end()) {
    append_sites(from, divided->second, line);
    append_sites(divided->second, to, line);
  } else {
    line.push_back(to);
  }
}

}  // namespace wirewarp
