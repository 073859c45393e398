// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/open_slits.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "base/planar.h"
#include "newton/minimize.h"
#include "newton/sewn_problem.h"
#include "surface/mesh/geometry.h"
#include "surface/mesh/overlap.h"

namespace wirewarp {
namespace {

constexpr double kOpening = 0.1;  // slope of an opened rim against the shut slit, far less than the angles of triangles
// Largest share of a face's height by which a rim moves into the face, so that no face flips.
constexpr double kOfHeight = 1.0 / 3;
// Depth that counts as overlap, divided by the diagonal of the piece. Later checks allow ten times this depth, because
// the diagonal may be shorter after the piece is rotated.
constexpr double kOverlapDepth = 1e-10;

/// Returns the distance along the rims to the nearest tip, for the vertex where each half-edge begins.
std::vector<double> distances_from_tips(const Chart& chart, const Slit& slit) {
  std::vector<double> distance(slit.rims.size(), 0);
  for (std::size_t i = 1; i < distance.size(); ++i) {
    const bool is_tip = slit.mate[i] == static_cast<int>(i) - 1;
    distance[i] = is_tip ? 0 : distance[i - 1] + edge_length(chart.mesh, slit.rims[i - 1]);
  }
  double to_next = 0;
  for (std::size_t i = distance.size(); i-- > 0;) {
    to_next = distance[i] == 0 ? 0 : to_next + edge_length(chart.mesh, slit.rims[i]);
    distance[i] = std::min(distance[i], to_next);
  }
  return distance;
}

/// Returns the least height, in the plane, of the faces around the vertex where a half-edge begins.
double height_beside(const Chart& chart, HalfedgeHandle rim, const Positions2& uv) {
  const auto place = [&](VertexHandle v) -> Eigen::Vector2d { return uv.row(v.idx()); };
  double least = std::numeric_limits<double>::infinity();
  for (const FaceHandle face : chart.mesh.vf_range(chart.mesh.from_vertex_handle(rim))) {
    const HalfedgeHandle h = chart.mesh.halfedge_handle(face);
    const Eigen::Vector2d a = place(chart.mesh.from_vertex_handle(h)), b = place(chart.mesh.to_vertex_handle(h)),
                          c = place(chart.mesh.from_vertex_handle(chart.mesh.prev_halfedge_handle(h)));
    const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
    least = std::min(least, std::abs(cross(b - a, c - a)) / longest);
  }
  return least;
}

void open_a_little(const Chart& chart, const Slit& slit, Positions2& uv) {
  const std::vector<double> distance = distances_from_tips(chart, slit);
  const std::size_t count = slit.rims.size();
  const auto vertex = [&](std::size_t i) { return chart.mesh.from_vertex_handle(slit.rims[i % count]).idx(); };
  Positions2 moved(count, 2);
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::RowVector2d along = (uv.row(vertex(i + 1)) - uv.row(vertex(i + count - 1))).normalized();
    const double by = std::min(kOpening * distance[i], kOfHeight * height_beside(chart, slit.rims[i], uv));
    moved.row(static_cast<Eigen::Index>(i)) = uv.row(vertex(i)) + by * Eigen::RowVector2d(-along.y(), along.x());
  }
  for (std::size_t i = 0; i < count; ++i) uv.row(vertex(i)) = moved.row(static_cast<Eigen::Index>(i));
}

bool touches(const Chart& chart, const Slit& slit, const std::vector<int>& faces) {
  return std::any_of(slit.rims.begin(), slit.rims.end(), [&](HalfedgeHandle h) {
    return std::binary_search(faces.begin(), faces.end(), chart.mesh.face_handle(h).idx());
  });
}

}  // namespace

Solution open_slits(Problem& problem, const Stage& stage, const Solution& shut, const Control& control) {
  const Chart& chart = problem.chart();
  Solution best = shut;
  std::vector<Slit> sewn_slits, open;
  for (const Slit& slit : problem.slits()) (slit.rims.size() == 2 ? sewn_slits : open).push_back(slit);
  const auto may_go_on = [&] { return control.budget.allows() && !control.stop.is_stopped(); };
  while (!open.empty() && may_go_on()) {
    const std::unique_ptr<SewnProblem> sewn = sew_slits(problem, stage, sewn_slits);
    if (!sewn) return best;
    Shape start{best.shape.uv, {}, best.shape.multipliers};
    for (const Slit& slit : open) open_a_little(chart, slit, start.uv);
    Solution trial = sewn->minimize(start, control);
    if (!may_go_on() && !trial.is_converged()) best.status = SolutionStatus::stalled;
    if (!trial.is_exact()) return best;
    const std::vector<int> overlapping_faces =
        find_overlapping_faces(triangles_of(chart.mesh), faces_on_boundary(chart.mesh), trial.shape.uv, kOverlapDepth);
    if (overlapping_faces.empty()) return trial.objective < best.objective ? trial : best;
    const auto crossed = std::stable_partition(
        open.begin(), open.end(), [&](const Slit& slit) { return !touches(chart, slit, overlapping_faces); });
    if (crossed == open.end()) return best;
    sewn_slits.insert(sewn_slits.end(), crossed, open.end());
    open.erase(crossed, open.end());
  }
  if (!open.empty()) best.status = SolutionStatus::stalled;
  return best;
}

}  // namespace wirewarp
