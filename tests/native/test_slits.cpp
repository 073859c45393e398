// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that slits are found among the boundary loops, and are sewn.
#include <gtest/gtest.h>

#include "surface/charts/slits.h"
#include "surface/mesh/geometry.h"
#include "test_meshes.h"

namespace wirewarp::test_slits {
namespace {

int vertex(int i, int j) { return i + 9 * j; }  // of a grid of 8 by 8 quads

FlattenInput sheet() {
  return test::make_grid(8, 8, [](double s, double t) { return Eigen::Vector3d(s, t, 0.3 * s * t); });
}

/// Returns a sheet with a T-shaped slit of three branches. One branch has a corner.
FlattenInput sheet_with_tree() {
  FlattenInput input = sheet();
  test::add_seam(input, {vertex(2, 4), vertex(3, 4), vertex(4, 4), vertex(5, 4), vertex(5, 5)});
  test::add_seam(input, {vertex(4, 4), vertex(4, 3)});
  return input;
}

TEST(Slits, AreLoopsThatContainBothRimsOfEveryEdge) {
  const Chart chart = test::chart_of(sheet_with_tree());
  const std::vector<Slit> slits = find_slits(chart);
  ASSERT_EQ(slits.size(), 1U);
  const Slit& slit = slits[0];
  ASSERT_EQ(slit.rims.size(), 10U);  // both rims of five edges
  EXPECT_EQ(slit.mate.front(), 9) << "the slit begins at a tip";
  for (std::size_t i = 0; i < slit.rims.size(); ++i) {
    const std::size_t other = slit.mate[i];
    EXPECT_EQ(slit.mate[other], static_cast<int>(i));
    EXPECT_EQ(source_edge(chart, slit.rims[i]), source_edge(chart, slit.rims[other]));
    EXPECT_NE(slit.rims[i], slit.rims[other]);
  }
}

TEST(Slits, DartsHolesAndKeyholesAreNotSlits) {
  FlattenInput dart = sheet();
  test::add_seam(dart, {vertex(0, 4), vertex(1, 4), vertex(2, 4)});
  FlattenInput hole = test::flat_annulus(12, 3, 1, 2);
  FlattenInput keyhole = test::keep_faces(
      sheet(), [](const Eigen::Vector3d& p) { return std::abs(p.x() - 0.5) > 0.12 || std::abs(p.y() - 0.5) > 0.12; });
  const int corner = test::nearest_vertex(keyhole, {0.375, 0.375, 0.3 * 0.375 * 0.375});
  test::add_seam(keyhole, {corner, test::nearest_vertex(keyhole, {0.25, 0.375, 0.3 * 0.25 * 0.375})});
  for (const FlattenInput& input : {dart, hole, keyhole}) {
    EXPECT_TRUE(find_slits(test::chart_of(input)).empty());
  }
}

TEST(Slits, BecomeRigidWiresWhenSewn) {
  FlattenInput input = sheet_with_tree();
  test::add_wire(input, test::grid_row(8, 6), 0.05);
  test::add_wire(input, test::grid_column(8, 8, 3));  // in two parts, across the slit
  const Chart open = test::chart_of(input), whole = test::chart_of(sheet());
  const std::optional<SewnChart> sewn = sew(open, find_slits(open));
  ASSERT_TRUE(sewn);
  EXPECT_EQ(sewn->chart.mesh.n_vertices(), whole.mesh.n_vertices());
  EXPECT_EQ(sewn->chart.mesh.n_edges(), whole.mesh.n_edges());
  EXPECT_EQ(sewn->chart.boundary_loops.size(), 1U);
  const Positions3 points = points_of(sewn->chart.mesh);
  for (std::size_t v = 0; v < sewn->vertex.size(); ++v) {
    EXPECT_EQ(points.row(sewn->vertex[v]), input.vertices.row(open.source_vertex[v]));
  }
  ASSERT_GT(sewn->chart.wire_parts.size(), open.wire_parts.size());
  double sewn_length = 0;
  for (std::size_t i = 0; i < sewn->chart.wire_parts.size(); ++i) {
    const WirePart& part = sewn->chart.wire_parts[i];
    if (i < open.wire_parts.size()) {
      EXPECT_EQ(part.kind, open.wire_parts[i].kind);
      EXPECT_EQ(part.half_edges.size(), open.wire_parts[i].half_edges.size());
      continue;
    }
    EXPECT_EQ(part.kind, WireKind::rigid);
    for (const HalfedgeHandle h : part.half_edges) sewn_length += edge_length(sewn->chart.mesh, h);
  }
  double slit_length = 0;
  for (int i = 0; i < input.seams.rows(); ++i) {
    slit_length += (input.vertices.row(input.seams(i, 0)) - input.vertices.row(input.seams(i, 1))).norm();
  }
  EXPECT_DOUBLE_EQ(sewn_length, slit_length);
}

TEST(Slits, SomeMayStayOpen) {
  FlattenInput input = sheet();
  test::add_seam(input, {vertex(2, 2), vertex(3, 2), vertex(4, 2)});
  test::add_seam(input, {vertex(2, 5), vertex(3, 5), vertex(4, 5)});
  const Chart chart = test::chart_of(input);
  const std::vector<Slit> slits = find_slits(chart);
  ASSERT_EQ(slits.size(), 2U);
  const std::optional<SewnChart> sewn = sew(chart, {slits[0]});
  ASSERT_TRUE(sewn);
  EXPECT_EQ(find_slits(sewn->chart).size(), 0U) << "the copies of a vertex have no common source";
  EXPECT_EQ(sewn->chart.boundary_loops.size(), 2U);
}

}  // namespace
}  // namespace wirewarp::test_slits
