// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/planar.h"
#include "surface/mesh/overlap.h"
#include "test_meshes.h"

namespace wirewarp::test_overlap {
namespace {

using test::charts_of;
using test::planar_positions;

/// A chart's faces, and whether each face has an edge on the outline.
struct Faces {
  Triangles corners;
  std::vector<bool> on_boundary;
};

Faces faces_of(const Chart& chart) {
  Faces faces{Triangles(static_cast<Eigen::Index>(chart.mesh.n_faces()), 3), {}};
  for (const FaceHandle f : chart.mesh.faces()) {
    int k = 0;
    for (const VertexHandle v : chart.mesh.fv_ccw_range(f)) faces.corners(f.idx(), k++) = v.idx();
    bool on_boundary = false;
    for (const HalfedgeHandle h : chart.mesh.fh_range(f)) {
      on_boundary |= chart.mesh.is_boundary(chart.mesh.opposite_halfedge_handle(h));
    }
    faces.on_boundary.push_back(on_boundary);
  }
  return faces;
}

std::vector<int> overlapping_faces(const Chart& chart, const Positions2& uv) {
  const Faces faces = faces_of(chart);
  return find_overlapping_faces(faces.corners, faces.on_boundary, uv);
}

/// Returns a square of side 2 with a slit from the middle of its lower side to its center.
FlattenInput slit_square(int n) {
  FlattenInput input = test::flat_rectangle(2 * n, 2 * n, 2, 2);
  std::vector<int> slit = test::grid_column(2 * n, 2 * n, n);
  slit.resize(static_cast<std::size_t>(n) + 1);
  test::add_seam(input, slit);
  return input;
}

/// Returns a strip bent around the origin by this angle in radians, between radii 1 and 2.
Positions2 bent_strip(const Chart& chart, int nx, double angle) {
  Positions2 uv(static_cast<Eigen::Index>(chart.mesh.n_vertices()), 2);
  for (int v = 0; v < uv.rows(); ++v) {
    const double turn = -angle * (v % (nx + 1)) / nx;
    const int ring = v / (nx + 1);
    const double radius = 1 + ring;
    uv.row(v) << radius * std::cos(turn), radius * std::sin(turn);
  }
  return uv;
}

TEST(Overlap, ASlitThatIsExactlyClosedDoesNotOverlap) {
  const Chart chart = test::chart_of(slit_square(8));
  Positions2 uv = planar_positions(chart);
  EXPECT_TRUE(overlapping_faces(chart, uv).empty());

  std::mt19937 random(3);
  std::uniform_real_distribution<double> noise(-1e-14, 1e-14);
  for (double& x : uv.reshaped()) x += noise(random);
  EXPECT_TRUE(overlapping_faces(chart, uv).empty());
  // Far from the origin, rounding errors are a thousand times larger.
  uv.rowwise() += Eigen::RowVector2d(2e3, -1e3);
  EXPECT_TRUE(overlapping_faces(chart, uv).empty());
}

TEST(Overlap, ASlitWithSlightlyOverlappingSidesIsFound) {
  const int n = 8;
  const Chart chart = test::chart_of(slit_square(n));
  // The left side of the slit overlaps the right side, by 1e-6 at the mouth and 0 at the center.
  Positions2 uv = planar_positions(chart);
  std::vector<bool> is_left(chart.mesh.n_vertices(), false);
  for (const FaceHandle f : chart.mesh.faces()) {
    for (const VertexHandle v : chart.mesh.fv_range(f)) {
      if (chart.mesh.calc_face_centroid(f)[0] < 1) is_left[static_cast<std::size_t>(v.idx())] = true;
    }
  }
  for (int v = 0; v < uv.rows(); ++v) {
    const bool is_slit = uv(v, 0) == 1 && uv(v, 1) < 1;
    if (is_slit && is_left[static_cast<std::size_t>(v)]) uv(v, 0) += 1e-6 * (1 - uv(v, 1));
  }
  const std::vector<int> found = overlapping_faces(chart, uv);
  // On each side of the slit, n triangles have an edge on the slit. The left triangles overlap the right triangles.
  EXPECT_GE(found.size(), 2 * static_cast<std::size_t>(n));
  for (const int f : found) {
    EXPECT_NEAR(chart.mesh.calc_face_centroid(chart.mesh.face_handle(static_cast<unsigned>(f)))[0], 1, 1.0 / n);
  }
}

TEST(Overlap, AStripBentPastAFullTurnOverlapsItsBeginning) {
  const int nx = 40;
  const Chart chart = test::chart_of(test::flat_rectangle(nx, 1, 10, 1));
  EXPECT_TRUE(overlapping_faces(chart, bent_strip(chart, nx, 2 * kPi)).empty());

  // Each of the 40 quads spans 1/40 of 2.2π. The section beyond 2π has 40 (0.2 / 2.2) = 3.6 quads, and overlaps the
  // first 3.6 quads.
  const std::vector<int> found = overlapping_faces(chart, bent_strip(chart, nx, 2.2 * kPi));
  std::vector<int> expected;
  for (const int quad : {0, 1, 2, 3, 36, 37, 38, 39}) {
    expected.push_back(2 * quad);
    expected.push_back(2 * quad + 1);
  }
  EXPECT_EQ(found, expected);
}

/// Returns the overlapping faces of a ring that runs around the middle twice, with one band between any two consecutive
/// radii.
std::vector<int> overlap_of_ring_wound_twice(const std::vector<double>& radii) {
  const int nx = 24;
  const Chart chart = test::chart_of(test::flat_annulus(nx, static_cast<int>(radii.size()) - 1, 1, 2));
  Positions2 uv(static_cast<Eigen::Index>(chart.mesh.n_vertices()), 2);
  for (int v = 0; v < uv.rows(); ++v) {
    const double turn = -4 * kPi * (v % nx) / nx;
    const double radius = radii[static_cast<std::size_t>(v / nx)];
    uv.row(v) << radius * std::cos(turn), radius * std::sin(turn);
  }
  return overlapping_faces(chart, uv);
}

TEST(Overlap, ARingWoundTwiceOverlapsEverywhereWithoutCrossings) {
  EXPECT_EQ(overlap_of_ring_wound_twice({1, 1.5, 2}).size(), 24U * 2 * 2);
}

TEST(Overlap, RimsTooThinToOverlapDoNotHideTheFacesBehind) {
  // The band between the rims overlaps itself. Rims of width 1e-10 are too thin to overlap by more than rounding
  // errors.
  EXPECT_EQ(overlap_of_ring_wound_twice({1, 1 + 1e-10, 2 - 1e-10, 2}).size(), 24U * 2);
}

/// Returns the area of the intersection of two triangles. Clips one triangle with the edges of the other triangle.
double common_area(const Triangles& faces, const Positions2& uv, int a, int b) {
  const auto corner = [&](int f, int k) -> Eigen::Vector2d { return uv.row(faces(f, k)); };
  const auto cross = [](const Eigen::Vector2d& p, const Eigen::Vector2d& q) { return p.x() * q.y() - p.y() * q.x(); };
  std::vector<Eigen::Vector2d> polygon = {corner(a, 0), corner(a, 1), corner(a, 2)};
  const double turn = cross(corner(b, 1) - corner(b, 0), corner(b, 2) - corner(b, 0)) < 0 ? -1 : 1;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector2d p = corner(b, k);
    const Eigen::Vector2d edge = turn * (corner(b, (k + 1) % 3) - p);
    std::vector<Eigen::Vector2d> clipped;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Eigen::Vector2d& from = polygon[i];
      const Eigen::Vector2d& to = polygon[(i + 1) % polygon.size()];
      const double s = cross(edge, from - p);
      const double t = cross(edge, to - p);
      if (s >= 0) clipped.push_back(from);
      if ((s > 0 && t < 0) || (s < 0 && t > 0)) clipped.push_back(from + (to - from) * (s / (s - t)));
    }
    polygon = clipped;
  }
  double area = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) area += cross(polygon[i], polygon[(i + 1) % polygon.size()]) / 2;
  return std::abs(area);
}

TEST(Overlap, FacesAtOnePointAreNotComparedInPairs) {
  const Chart chart = test::chart_of(test::flat_rectangle(60, 60, 1, 1));
  const Faces faces = faces_of(chart);
  const Positions2 uv = Positions2::Zero(static_cast<Eigen::Index>(chart.mesh.n_vertices()), 2);
  // A comparison of all pairs of the 7,200 faces would poll and throw. A search without pairs has too little work.
  const StopToken once_is_too_often([](const char*) { return false; });
  EXPECT_TRUE(find_overlapping_faces(faces.corners, faces.on_boundary, uv, 1e-9, once_is_too_often).empty());
}

TEST(Overlap, AgreesWithTheAreaOfEveryPairOfFaces) {
  const Chart chart = test::chart_of(test::flat_rectangle(7, 7, 7, 7));
  const Faces faces = faces_of(chart);
  std::mt19937 random(5);
  for (const double spread : {0.3, 0.6, 1.5}) {
    Positions2 uv = planar_positions(chart);
    std::uniform_real_distribution<double> noise(-spread, spread);
    for (double& x : uv.reshaped()) x += noise(random);
    std::vector<bool> overlaps(static_cast<std::size_t>(faces.corners.rows()), false);
    for (int a = 0; a < faces.corners.rows(); ++a) {
      for (int b = 0; b < a; ++b) {
        if (common_area(faces.corners, uv, a, b) < 1e-12) continue;
        overlaps[static_cast<std::size_t>(a)] = overlaps[static_cast<std::size_t>(b)] = true;
      }
    }
    std::vector<int> expected;
    for (std::size_t f = 0; f < overlaps.size(); ++f) {
      if (overlaps[f]) expected.push_back(static_cast<int>(f));
    }
    EXPECT_EQ(find_overlapping_faces(faces.corners, faces.on_boundary, uv), expected) << spread;
  }
}

}  // namespace
}  // namespace wirewarp::test_overlap
