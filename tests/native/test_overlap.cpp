// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "base/planar.h"
#include "dense_algebra.h"
#include "planar_overlap.h"
#include "surface/mesh/overlap.h"
#include "test_meshes.h"

namespace wirewarp::test_overlap {
namespace {

using test::planar_positions;

struct Faces {
  Triangles corners;
  std::vector<bool> on_boundary;  // whether a face has an edge on the outline
};

Faces faces_of(const Chart& chart) {
  Faces faces{Triangles(chart.mesh.n_faces(), 3), {}};
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

FlattenInput slit_square(int n) {
  FlattenInput input = test::flat_rectangle(2 * n, 2 * n, 2, 2);
  test::add_seam(input, test::section(test::grid_column(2 * n, 2 * n, n), 0, n));
  return input;
}

Positions2 bent_strip(const Chart& chart, int nx, double angle) {
  Positions2 uv(chart.mesh.n_vertices(), 2);
  for (int v = 0; v < uv.rows(); ++v) {
    const double turn = -angle * (v % (nx + 1)) / nx, radius = 1 + v / (nx + 1);
    uv.row(v) << radius * std::cos(turn), radius * std::sin(turn);
  }
  return uv;
}

TEST(Overlap, ASlitThatIsExactlyClosedDoesNotOverlap) {
  const Chart chart = test::chart_of(slit_square(8));
  Positions2 uv = planar_positions(chart);
  EXPECT_TRUE(overlapping_faces(chart, uv).empty());
  uv += 5e-15 * test::random_normal(uv.rows(), 2, 3);
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
      if (chart.mesh.calc_face_centroid(f)[0] < 1) is_left[v.idx()] = true;
    }
  }
  for (int v = 0; v < uv.rows(); ++v) {
    const bool is_slit = uv(v, 0) == 1 && uv(v, 1) < 1;
    if (is_slit && is_left[v]) uv(v, 0) += 1e-6 * (1 - uv(v, 1));
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
  EXPECT_EQ(found, (std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7, 72, 73, 74, 75, 76, 77, 78, 79}));
}

/// Returns the overlapping faces of a ring that runs around the middle twice, with one band between any two consecutive
/// radii.
std::vector<int> overlap_of_ring_wound_twice(const std::vector<double>& radii) {
  const int nx = 24;
  const Chart chart = test::chart_of(test::flat_annulus(nx, static_cast<int>(radii.size()) - 1, 1, 2));
  Positions2 uv(chart.mesh.n_vertices(), 2);
  for (int v = 0; v < uv.rows(); ++v) {
    const double turn = -4 * kPi * (v % nx) / nx, radius = radii[v / nx];
    uv.row(v) << radius * std::cos(turn), radius * std::sin(turn);
  }
  return overlapping_faces(chart, uv);
}

TEST(Overlap, ARingWoundTwiceOverlapsEverywhereWithoutCrossings) {
  EXPECT_EQ(overlap_of_ring_wound_twice({1, 1.5, 2}).size(), 24U * 2 * 2);
  // Bands of width 1e-10 at both rims overlap only by rounding errors. They must not hide the wide band between them.
  EXPECT_EQ(overlap_of_ring_wound_twice({1, 1 + 1e-10, 2 - 1e-10, 2}).size(), 24U * 2);
}

TEST(Overlap, FacesAtOnePointAreNotComparedInPairs) {
  const Chart chart = test::chart_of(test::flat_rectangle(60, 60, 1, 1));
  const Faces faces = faces_of(chart);
  const Positions2 uv = Positions2::Zero(chart.mesh.n_vertices(), 2);
  // A comparison of all pairs of the 7,200 faces would poll and throw. A search without pairs has too little work to
  // poll.
  const StopToken once_is_too_often([](const char*) { return false; });
  EXPECT_TRUE(find_overlapping_faces(faces.corners, faces.on_boundary, uv, 1e-9, once_is_too_often).empty());
}

/// The judge compares pairs of triangles in another way.
TEST(Overlap, AgreesWithTheJudgeAboutEveryPairOfFaces) {
  const Chart chart = test::chart_of(test::flat_rectangle(7, 7, 7, 7));
  const Faces faces = faces_of(chart);
  for (const double spread : {0.2, 1.0}) {
    const Positions2 flat = planar_positions(chart), uv = flat + spread * test::random_normal(flat.rows(), 2, 5);
    std::vector<bool> overlaps(faces.corners.rows(), false);
    const auto triangle = [&](int f) {
      const auto corner = [&](int k) -> Eigen::Vector2d { return uv.row(faces.corners(f, k)); };
      test::PlanarTriangle found{corner(0), corner(1), corner(2)};
      if (test::doubled_area(found) < 0) std::swap(found[1], found[2]);
      return found;
    };
    for (int a = 0; a < faces.corners.rows(); ++a) {
      for (int b = 0; b < a; ++b) {
        if (test::find_overlap({triangle(a), triangle(b)}).first < 0) continue;
        overlaps[a] = overlaps[b] = true;
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
