// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/mesh/overlap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "base/planar.h"
#include "base/work_meter.h"
#include "surface/mesh/box_tree.h"

namespace wirewarp {
namespace {

using Corners = std::array<Eigen::Vector2d, 3>;

Corners corners_of(const Triangles& faces, const Positions2& uv, int face) {
  return {uv.row(faces(face, 0)), uv.row(faces(face, 1)), uv.row(faces(face, 2))};
}

Corners counter_clockwise(Corners t) {
  if (cross(t[1] - t[0], t[2] - t[0]) < 0) std::swap(t[1], t[2]);
  return t;
}

/// Returns the bounding box, reduced by `depth` on every side, but not empty. If two triangles penetrate each other by
/// at least twice the depth, their reduced boxes meet.
Box2 inner_box(const Corners& t, double depth) {
  const Eigen::Vector2d low = t[0].cwiseMin(t[1]).cwiseMin(t[2]);
  const Eigen::Vector2d high = t[0].cwiseMax(t[1]).cwiseMax(t[2]);
  const Eigen::Vector2d inset = Eigen::Vector2d::Constant(depth).cwiseMin((high - low) / 2);
  return Box2(low + inset, high - inset);
}

/// Returns whether b reaches more than `depth` across every edge of a, toward the inside of a. Both must be
/// counter-clockwise.
bool reaches_behind_every_edge(const Corners& a, const Corners& b, double depth) {
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector2d edge = a[(i + 1) % 3] - a[i];
    const double reach = std::max({cross(edge, b[0] - a[i]), cross(edge, b[1] - a[i]), cross(edge, b[2] - a[i])});
    if (reach <= depth * edge.norm()) return false;
  }
  return true;
}

/// Separating axis test: the penetration of two convex polygons is the least overlap along the normals of their edges.
bool penetrate(const Corners& a, const Corners& b, double depth) {
  return reaches_behind_every_edge(a, b, depth) && reaches_behind_every_edge(b, a, depth);
}

/// Returns whether an edge of the face has no length. Other faces cannot penetrate such a face.
bool is_collapsed(const Corners& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

/// Returns one flag per face: whether the face is one of two overlapping faces, of which at least one is a candidate.
/// Candidates must not be collapsed.
std::vector<bool> overlaps_with(const std::vector<int>& candidates, const Triangles& faces, const Positions2& uv,
                                double depth, const StopToken& stop) {
  WorkMeter work(stop);
  std::vector<Box2> boxes;
  boxes.reserve(candidates.size());
  std::vector<bool> is_candidate(static_cast<std::size_t>(faces.rows()), false);
  for (const int face : candidates) {
    boxes.push_back(inner_box(corners_of(faces, uv, face), depth / 2));
    is_candidate[static_cast<std::size_t>(face)] = true;
  }
  const BoxTree tree(boxes);

  std::vector<bool> overlaps(static_cast<std::size_t>(faces.rows()), false);
  for (int face = 0; face < faces.rows(); ++face) {
    const Corners triangle = corners_of(faces, uv, face);
    if (is_collapsed(triangle)) continue;
    const bool is_both = is_candidate[static_cast<std::size_t>(face)];
    work.did(1);
    tree.for_each_meeting(inner_box(triangle, depth / 2), [&](int item) {
      work.did(1);
      const int other = candidates[static_cast<std::size_t>(item)];
      if (is_both && other <= face) return;  // the same face, or a pair that is tested from the other face
      if (penetrate(counter_clockwise(triangle), counter_clockwise(corners_of(faces, uv, other)), depth)) {
        overlaps[static_cast<std::size_t>(face)] = true;
        overlaps[static_cast<std::size_t>(other)] = true;
      }
    });
  }
  return overlaps;
}

bool any_not_positive(const Triangles& faces, const Positions2& uv) {
  for (int face = 0; face < faces.rows(); ++face) {
    const Corners t = corners_of(faces, uv, face);
    if (!(cross(t[1] - t[0], t[2] - t[0]) > 0)) return true;
  }
  return false;
}

/// Returns whether any candidate is so thin (a few times the depth of overlaps) that other faces cannot penetrate it.
bool any_too_thin(const std::vector<int>& candidates, const Triangles& faces, const Positions2& uv, double depth) {
  return std::any_of(candidates.begin(), candidates.end(), [&](int face) {
    const Corners t = corners_of(faces, uv, face);
    const double base = std::max({(t[1] - t[0]).norm(), (t[2] - t[1]).norm(), (t[0] - t[2]).norm()});
    return cross(t[1] - t[0], t[2] - t[0]) < 4 * depth * base;
  });
}

bool any(const std::vector<bool>& flags) { return std::find(flags.begin(), flags.end(), true) != flags.end(); }

std::vector<int> indices_of(const std::vector<bool>& flags) {
  std::vector<int> indices;
  for (std::size_t i = 0; i < flags.size(); ++i) {
    if (flags[i]) indices.push_back(static_cast<int>(i));
  }
  return indices;
}

}  // namespace

std::vector<int> find_overlapping_faces(const Triangles& faces, const std::vector<bool>& on_boundary,
                                        const Positions2& uv, double relative_depth, const StopToken& stop) {
  if (faces.rows() == 0) return {};
  const double size = (uv.colwise().maxCoeff() - uv.colwise().minCoeff()).norm();
  const double rounding = 8 * std::numeric_limits<double>::epsilon() * uv.cwiseAbs().maxCoeff();
  const double depth = relative_depth * size + rounding;

  // Without flips, a region that is covered twice ends at a boundary edge whose face overlaps another face. Therefore,
  // if no boundary face overlaps, no face does. This test visits every face once.
  const std::vector<int> boundary = indices_of(on_boundary);
  if (!any_not_positive(faces, uv) && !any_too_thin(boundary, faces, uv, depth) &&
      !any(overlaps_with(boundary, faces, uv, depth, stop))) {
    return {};
  }

  std::vector<int> spread;
  for (int face = 0; face < faces.rows(); ++face) {
    if (!is_collapsed(corners_of(faces, uv, face))) spread.push_back(face);
  }
  return indices_of(overlaps_with(spread, faces, uv, depth, stop));
}

std::vector<bool> faces_on_boundary(const HalfEdgeMesh& mesh) {
  std::vector<bool> flags(mesh.n_faces(), false);
  for (const HalfedgeHandle h : mesh.halfedges()) {
    if (mesh.is_boundary(h)) flags[mesh.face_handle(mesh.opposite_halfedge_handle(h)).idx()] = true;
  }
  return flags;
}

}  // namespace wirewarp
