// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of seams that are suggested for pieces that cannot be flattened.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/planar.h"
#include "closed_meshes.h"
#include "cuts/feasibility/cut_apart.h"
#include "cuts/feasibility/cut_to_disk.h"
#include "cuts/feasibility/open_chart.h"
#include "cuts/feasibility/ranks.h"
#include "newton/solve/chart_errors.h"
#include "surface/charts/chart_faults.h"
#include "surface/charts/isoperimetric.h"
#include "test_meshes.h"

namespace wirewarp::test_proposed_seams {
namespace {

/// Returns the part of the unit sphere at angles from `hole` to `angle` from the south pole, in radians.
FlattenInput cap(int around, int rings, double hole, double angle) {
  return test::make_tube(around, rings, [&](double s, double t) {
    const double a = hole + (angle - hole) * t;
    return Eigen::Vector3d(std::sin(a) * std::cos(2 * kPi * s), std::sin(a) * std::sin(2 * kPi * s), -std::cos(a));
  });
}

/// Returns a tube with the coincident vertices of its first ring merged, and without the triangles that have no area.
FlattenInput close_bottom(const FlattenInput& tube, int around) {
  FlattenInput closed = tube;
  int kept = 0;
  for (int f = 0; f < tube.faces.rows(); ++f) {
    Eigen::RowVector3i face = tube.faces.row(f);
    for (int& v : face) v = v < around ? 0 : v - around + 1;
    if (face[0] == face[1] || face[1] == face[2] || face[2] == face[0]) continue;
    closed.faces.row(kept++) = face;
  }
  closed.faces.conservativeResize(kept, 3);
  closed.vertices = tube.vertices.bottomRows(tube.vertices.rows() - around + 1);
  return closed;
}

FlattenInput cone(int around) {
  return test::make_tube(around, 8, [](double s, double t) {
    const double radius = 0.5 + 0.5 * t;
    return Eigen::Vector3d(radius * std::cos(2 * kPi * s), radius * std::sin(2 * kPi * s), 5 * t);
  });
}

using test::cubes;

FlattenInput plate_with_two_handles() {
  return cubes(5, 3, 1, [](int i, int j, int) { return j != 1 || i % 2 == 0; });
}

bool has_proposal(const Piece& piece) { return piece.error && !piece.error->elements.proposed_seams.empty(); }

std::vector<ErrorCode> codes_of(const FlattenResult& result) {
  std::vector<ErrorCode> codes;
  for (const Piece& piece : result.pieces) {
    if (piece.error) codes.push_back(piece.error->code);
  }
  return codes;
}

/// Adds suggested seams and flattens again until no seams are suggested, but at most 10 times. Returns the number of
/// rounds.
int follow_proposals(FlattenInput& input, FlattenResult& result) {
  for (int rounds = 0;; ++rounds) {
    result = flatten(input);
    bool has_any = false;
    for (const Piece& piece : result.pieces) {
      if (!has_proposal(piece)) continue;
      has_any = true;
      for (const VertexPair& seam : piece.error->elements.proposed_seams) test::add_seam(input, {seam[0], seam[1]});
    }
    if (!has_any || rounds == 10) return rounds;
  }
}

TEST(ProposedSeams, LeadToFlatPieces) {
  constexpr ErrorCode kShort = ErrorCode::boundary_too_short, kClosed = ErrorCode::closed_chart;
  const auto solid = [](int, int, int) { return true; };
  const FlattenInput tetrahedron =
      test::mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}});
  struct Case {
    const char* name;
    FlattenInput input;
    ErrorCode code;
    std::size_t pieces;
  };
  for (Case shape : std::vector<Case>{
           {"cylinder", test::cylinder_tube(16, 8, 1, 4), kShort, 1},
           {"cone", cone(16), kShort, 1},
           {"sphere", test::closed_sphere(16, 12), kClosed, 2},
           {"tetrahedron", tetrahedron, kClosed, 2},
           {"ball with a small hole", close_bottom(cap(16, 12, 0, kPi - 0.2), 16), kShort, 2},
           {"ball with two small holes", cap(16, 12, 0.2, kPi - 0.2), kShort, 1},
           {"cube", cubes(1, 1, 1, solid), kClosed, 2},
           {"long box", cubes(9, 1, 1, solid), kClosed, 1},
           {"torus", test::closed_torus(20, 10), kClosed, 1},
           {"plate with two handles", plate_with_two_handles(), kClosed, 1},
       }) {
    SCOPED_TRACE(shape.name);
    EXPECT_EQ(codes_of(flatten(shape.input)), std::vector<ErrorCode>{shape.code});
    FlattenResult result;
    EXPECT_EQ(follow_proposals(shape.input, result), 1);
    EXPECT_EQ(result.pieces.size(), shape.pieces);
    EXPECT_EQ(codes_of(result), std::vector<ErrorCode>{});
  }
}

/// These functions return garments as boxes with openings: trousers with two legs, a shirt with two sleeves, and a
/// glove with four fingers.
FlattenInput trousers() {
  const FlattenInput closed = cubes(5, 2, 10, [](int i, int, int k) { return k >= 6 || i != 2; });
  return test::keep_faces(closed, [](const Eigen::Vector3d& p) { return p.z() > 0 && p.z() < 10; });
}

FlattenInput shirt() {
  const FlattenInput closed = cubes(10, 2, 6, [](int i, int, int k) { return k >= 4 || (i >= 3 && i < 7); });
  return test::keep_faces(closed, [](const Eigen::Vector3d& p) {
    const bool is_neck = p.z() == 6 && p.x() > 4 && p.x() < 6;
    return p.z() > 0 && p.x() > 0 && p.x() < 10 && !is_neck;
  });
}

FlattenInput glove() {
  const FlattenInput closed = cubes(7, 1, 8, [](int i, int, int k) { return k < 4 || i % 2 == 0; });
  return test::keep_faces(closed, [](const Eigen::Vector3d& p) { return p.z() > 0; });
}

TEST(ProposedSeamsOfAGarment, LeadToFlatPieces) {
  for (FlattenInput input : {trousers(), shirt(), glove()}) {
    ASSERT_TRUE(has_proposal(flatten(input).pieces.at(0)));
    FlattenResult result;
    EXPECT_LE(follow_proposals(input, result), 3);
    EXPECT_EQ(codes_of(result), std::vector<ErrorCode>{});
    EXPECT_LE(result.pieces.size(), 5u);
    // These energies are as low as in a tailor's pattern.
    for (const Piece& piece : result.pieces) EXPECT_LT(piece.metrics.arap_energy, 0.1);
  }
}

/// Cuts a sheet along the seams that open_chart() suggests if is_flat() tests the pieces. Returns the number of faces
/// of each piece. If may_go_on is false, open_chart() is stopped.
std::vector<std::size_t> faces_after(const std::function<bool(const Chart&)>& is_flat, bool may_go_on) {
  FlattenInput input = test::flat_rectangle(8, 8, 1, 1);
  const Chart sheet = test::chart_of(input);
  const CutMask opening = open_chart(sheet, is_flat, StopToken([=](const char*) { return may_go_on; }));
  for (const EdgeHandle e : sheet.mesh.edges()) {
    if (opening[e.idx()] == 0) continue;
    const auto [from, to] = source_edge(sheet, sheet.mesh.halfedge_handle(e, 0));
    test::add_seam(input, {from, to});
  }
  std::vector<std::size_t> counts;
  const Charts cut = test::charts_of(input);
  for (const Chart& piece : cut.charts) counts.push_back(piece.source_face.size());
  return counts;
}

TEST(OpenChart, ProposesSomethingEvenIfNothingHelps) {
  EXPECT_GT(faces_after([](const Chart&) { return false; }, true).size(), 1u);
}

TEST(OpenChart, ProposesNothingOnceItIsStopped) {
  EXPECT_EQ(faces_after([](const Chart&) { return true; }, false), std::vector<std::size_t>{128});
}

TEST(Ranks, OfValuesThatDifferByRoundingAreEqual) {
  for (const double value : {0.0, 0.5e-6, 1.5e-6, 0.25}) {  // multiples of 1e-6, and values halfway between them
    EXPECT_EQ(ranks_of({value + 1e-12, 1, value, value - 1e-12}, 1e-6), (std::vector<int>{0, 1, 0, 0})) << value;
  }
}

TEST(ProposedSeamsOfATube, AreTheShortestPathBetweenItsLoops) {
  const int n = 16, rows = 4;
  const double height = 4;
  const FlattenInput input = test::cylinder_tube(n, rows, 1, height);
  const FlattenError error = flatten(input).pieces[0].error.value();
  EXPECT_EQ(error.elements.proposed_seams.size(), static_cast<std::size_t>(rows));
  double length = 0;
  for (const VertexPair& seam : error.elements.proposed_seams) {
    length += (input.vertices.row(seam[0]) - input.vertices.row(seam[1])).norm();
  }
  EXPECT_NEAR(length, height, 1e-12);
  ASSERT_EQ(error.elements.vertices.size(), 2u);
  EXPECT_EQ(error.elements.edges.size(), 2u * n);
  EXPECT_FALSE(error.has_layout);
}

TEST(ProposedSeamsOfABand, OpenBandsThatTheirOutlinesCouldEnclose) {
  // A straight waistband, a flared waistband and a belt on a ball. They are so narrow that their outlines could enclose
  // them in the plane.
  const FlattenInput flared = test::make_tube(32, 2, [](double s, double t) {
    const double radius = 1 - 0.1 * t;
    return Eigen::Vector3d(radius * std::cos(2 * kPi * s), radius * std::sin(2 * kPi * s), 0.3 * t);
  });
  for (FlattenInput input : {test::cylinder_tube(32, 2, 1, 0.3), flared, test::sphere_band(32, 4, 0.2)}) {
    const Piece folded = flatten(input).pieces.at(0);
    ASSERT_TRUE(has_proposal(folded));
    EXPECT_TRUE(folded.error->code == ErrorCode::flipped_faces || folded.error->code == ErrorCode::overlapping_faces);
    EXPECT_TRUE(folded.error->has_layout);
    FlattenResult result;
    EXPECT_EQ(follow_proposals(input, result), 1);
    EXPECT_EQ(codes_of(result), std::vector<ErrorCode>{});
  }
}

TEST(ProposedSeamsOfARing, LeadToFlatPieces) {
  // Cuffs, waistbands and collars with oval sections. They are straight, flared or bulging. Some have wires around
  // them, and some have upright wires.
  const int around = 24, rows = 3;
  for (int i = 0; i < 8; ++i) {
    const double flare = 0.15 * (i % 5 - 2), bulge = 0.1 * (i % 3), tall = 0.15 + 0.1 * (i % 4);
    FlattenInput input = test::make_tube(around, rows, [&](double s, double t) {
      const double radius = 1 + flare * t + 4 * bulge * t * (1 - t);
      return Eigen::Vector3d(radius * std::cos(2 * kPi * s), 0.7 * radius * std::sin(2 * kPi * s), tall * t);
    });
    if (i % 2 == 1) test::add_wire(input, test::tube_ring(around, 1));
    for (int line = 0; line < 4 && i % 4 > 1; ++line) {
      test::add_wire(input, test::tube_line(around, rows, 6 * line), i % 3 == 0 ? 0 : 0.03);
    }
    FlattenResult result;
    EXPECT_LE(follow_proposals(input, result), 3) << i;
    EXPECT_EQ(codes_of(result), std::vector<ErrorCode>{}) << i;
  }
}

TEST(CutToDisk, CutsEachHandleTwiceAndJoinsTheLoops) {
  const FlattenInput two_handles = plate_with_two_handles();
  // Without its last face, the surface has one boundary loop. Without its first and last face, which are apart, the
  // surface has two loops.
  for (const int dropped_faces : {1, 2}) {
    FlattenInput input = two_handles;
    const auto faces = static_cast<int>(two_handles.faces.rows());
    input.faces = two_handles.faces.middleRows(dropped_faces > 1 ? 1 : 0, faces - (dropped_faces > 1 ? 2 : 1));
    const Chart chart = test::chart_of(input);
    EXPECT_EQ(count_handles(chart), 2);
    const std::vector<Chart> pieces = cut_apart(chart, cut_to_disk(chart.mesh, CutMask(chart.mesh.n_edges(), 0)));
    ASSERT_EQ(pieces.size(), 1u);
    EXPECT_EQ(pieces[0].boundary_loops.size(), 1u);
    EXPECT_EQ(count_handles(pieces[0]), 0);
  }
}

TEST(CutToDisk, LeavesADiskAlone) {
  const Chart chart = test::chart_of(test::flat_rectangle(3, 3, 1, 1));
  const CutMask cut = cut_to_disk(chart.mesh, CutMask(chart.mesh.n_edges(), 0));
  EXPECT_EQ(std::count(cut.begin(), cut.end(), 1), 0);
}

TEST(Isoperimetric, KnownShapesHaveTheirRatios) {
  const auto ratio = [](const FlattenInput& input) { return isoperimetric_ratio(test::chart_of(input)); };
  EXPECT_NEAR(ratio(test::flat_rectangle(3, 3, 1, 1)), 16 / (4 * kPi), 1e-12);
  EXPECT_NEAR(ratio(cap(200, 100, 1e-6, kPi / 2)), 0.5, 1e-3);                 // (2 pi)^2 / (4 pi 2 pi)
  EXPECT_NEAR(ratio(test::cylinder_tube(200, 2, 1, 4)), 1 / (2 * 4.0), 1e-3);  // pi / (2 pi 4)
}

TEST(ShortOutline, IsNotReportedForPiecesThatCanBeFlattened) {
  const std::vector<FlattenInput> inputs{test::quarter_sphere(6), test::flat_plate_with_two_holes(4),
                                         test::flat_annulus(24, 3, 0.8, 1), close_bottom(cap(16, 6, 0, kPi / 2), 16),
                                         cap(16, 6, 0.1, kPi / 2)};
  for (const FlattenInput& input : inputs) {
    for (const ErrorCode code : codes_of(flatten(input))) EXPECT_NE(code, ErrorCode::boundary_too_short);
  }
}

}  // namespace
}  // namespace wirewarp::test_proposed_seams
