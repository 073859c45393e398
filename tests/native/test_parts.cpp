// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of the division of closed models into parts.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/planar.h"
#include "cuts/parts/crease_lines.h"
#include "cuts/parts/level_lines.h"
#include "cuts/parts/necks.h"
#include "cuts/parts/part_planes.h"
#include "cuts/propose/mirror_image.h"
#include "cuts/propose/part_sets.h"
#include "disguise.h"
#include "judge_cuts.h"
#include "surface/mesh/geodesic_distance.h"
#include "surface/mesh/geometry.h"
#include "test_meshes.h"
#include "wirewarp/cut_mesh.h"
#include "wirewarp/propose.h"

namespace wirewarp::test_parts {
namespace {

using test::chart_of;

/// Returns a closed surface of two balls on the z axis that have grown together, with a neck of radius 0.35 at z = 0.
FlattenInput dumbbell(int around, int rings) {
  FlattenInput input = test::closed_sphere(around, rings);
  for (auto p : input.vertices.rowwise()) {
    const double width = 0.35 + 0.65 * p[2] * p[2];
    p << width * p[0], width * p[1], 2 * p[2];
  }
  return input;
}

double error_on_sphere(int rings) {
  const Chart chart = chart_of(test::closed_sphere(2 * rings, rings));
  const VertexHandle pole = *std::max_element(
      chart.mesh.vertices_begin(), chart.mesh.vertices_end(),
      [&](VertexHandle a, VertexHandle b) { return chart.mesh.point(a)[2] < chart.mesh.point(b)[2]; });
  const Eigen::VectorXd distance = GeodesicDistance(chart.mesh, {}).from(pole);
  double error = 0;
  for (const VertexHandle v : chart.mesh.vertices())
    error = std::max(error, std::abs(distance[v.idx()] - std::acos(std::clamp(chart.mesh.point(v)[2], -1.0, 1.0))));
  return error;
}

TEST(GeodesicDistance, ConvergesToTheArcsOfASphere) {
  const double coarse = error_on_sphere(12), fine = error_on_sphere(24);
  EXPECT_LT(fine, 0.05);
  EXPECT_LT(fine, 0.75 * coarse);
}

TEST(GeodesicDistance, IsZeroAtItsVertexOnly) {
  const Chart chart = chart_of(dumbbell(16, 16));
  const Eigen::VectorXd distance = GeodesicDistance(chart.mesh, {}).from(VertexHandle(5));
  for (const VertexHandle v : chart.mesh.vertices()) EXPECT_EQ(distance[v.idx()] <= 0, v.idx() == 5) << v.idx();
}

TEST(LevelLines, CrossASheetFromOutlineToOutline) {
  const Chart chart = chart_of(test::flat_rectangle(5, 5, 1, 1));
  const Eigen::VectorXd x = points_of(chart.mesh).col(0);
  for (const double level : {0.37, 0.4}) {  // across triangles, and along edges
    const std::vector<MeshPath> lines = level_lines(chart.mesh, x, level);
    ASSERT_EQ(lines.size(), 1U) << level;
    EXPECT_NEAR(path_length(chart.mesh, lines[0]), 1, 1e-12) << level;
    EXPECT_NEAR(level_length(chart.mesh, x, level), 1, 1e-12) << level;
    for (const PathPoint& point : lines[0]) EXPECT_NEAR(position(chart.mesh, point)[0], level, 1e-12);
  }
}

TEST(LevelLines, CloseAroundATorus) {
  const Chart chart = chart_of(test::closed_torus(40, 20));
  const Eigen::VectorXd height = points_of(chart.mesh).col(2);
  const double level = 0.3 * height.maxCoeff();
  const std::vector<MeshPath> lines = level_lines(chart.mesh, height, level);
  ASSERT_EQ(lines.size(), 2U);  // the inner and the outer line
  double length = 0;
  for (const MeshPath& line : lines) {
    EXPECT_EQ((position(chart.mesh, line.front()) - position(chart.mesh, line.back())).norm(), 0);
    length += path_length(chart.mesh, line);
  }
  EXPECT_NEAR(length, level_length(chart.mesh, height, level), 1e-12 * length);
  EXPECT_TRUE(level_lines(chart.mesh, height, 2 * height.maxCoeff()).empty());
}

TEST(Necks, AreShortLoopsBetweenParts) {
  const Chart chart = chart_of(dumbbell(24, 24));
  const std::vector<Neck> necks = find_necks(chart.mesh, {}, {});
  ASSERT_EQ(necks.size(), 1U);
  EXPECT_NEAR(level_length(chart.mesh, necks[0].distance, necks[0].level), 2 * kPi * 0.35, 0.1 * 2 * kPi * 0.35);
  for (const MeshPath& line : level_lines(chart.mesh, necks[0].distance, necks[0].level)) {
    for (const PathPoint& point : line) EXPECT_LT(std::abs(position(chart.mesh, point)[2]), 0.3);
  }
}

TEST(Necks, AreSymmetricIfTheModelIs) {
  // A ball between two other balls. The model is symmetric across the plane z = 0.
  FlattenInput input = test::closed_sphere(24, 40);
  for (auto p : input.vertices.rowwise()) {
    const double width = 0.4 + 0.3 * std::cos(3 * kPi * p[2]);
    p << width * p[0], width * p[1], 3 * p[2];
  }
  const Chart chart = chart_of(input);
  std::vector<VertexHandle> image(chart.mesh.n_vertices());
  for (const VertexHandle v : chart.mesh.vertices()) {
    const HalfEdgeMesh::Point p = chart.mesh.point(v);
    const auto is_image = [&](VertexHandle w) {
      return (chart.mesh.point(w) - HalfEdgeMesh::Point(p[0], p[1], -p[2])).norm() < 1e-9;
    };
    image[v.idx()] = *std::find_if(chart.mesh.vertices_begin(), chart.mesh.vertices_end(), is_image);
  }
  const std::vector<Neck> necks = find_necks(chart.mesh, image, {});
  ASSERT_EQ(necks.size(), 2U);
  EXPECT_EQ(necks[0].level, necks[1].level);
  for (const VertexHandle v : chart.mesh.vertices())
    EXPECT_EQ(necks[0].distance[v.idx()], necks[1].distance[image[v.idx()].idx()]);
}

TEST(CreaseLines, FollowAnObliqueCrease) {
  FlattenInput input = test::closed_sphere(64, 96);
  // Two cones that meet at their narrowest section. They are sheared, so the crease is in the plane z = x.
  for (auto p : input.vertices.rowwise()) {
    const double width = 0.35 + 0.65 * std::min(2 * std::abs(p[2]), 1.0);
    p << width * p[0], width * p[1], 1.4 * p[2] + width * p[0];
  }
  const Chart chart = chart_of(input);
  const Eigen::VectorXd height = points_of(chart.mesh).col(2);
  const auto mean_from_crease = [&](const Eigen::VectorXd& values, double level) {
    double sum = 0, count = 0;
    for (const MeshPath& line : level_lines(chart.mesh, values, level)) {
      for (const PathPoint& point : line) {
        const HalfEdgeMesh::Point p = position(chart.mesh, point);
        sum += std::abs(p[2] - p[0]);
        ++count;
      }
    }
    return sum / count;
  };
  const Eigen::VectorXd potential = potential_across(chart.mesh, height, 0, level_length(chart.mesh, height, 0));
  EXPECT_GE(potential.minCoeff(), -1e-12);
  EXPECT_LE(potential.maxCoeff(), 1 + 1e-12);
  EXPECT_LT(mean_from_crease(potential, 0.5), mean_from_crease(height, 0) / 3);
}

TEST(Necks, AreMissingOnABall) { EXPECT_TRUE(find_necks(chart_of(test::closed_sphere(24, 16)).mesh, {}, {}).empty()); }

TEST(PartPlanes, AreMirroredWithTheirPartAndAlsoPassThroughAStrainedPlace) {
  const Chart half = chart_of(test::sphere_band(24, 6, 0.8));
  const Plane mirror{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX()};
  const Eigen::Vector3d strained(0.1, 0.2, 0.7);
  for (const Plane& plane : planes_through(half, strained, mirror)) {
    const Plane other = plane.mirrored(mirror);
    EXPECT_NEAR(std::abs(other.normal.dot(plane.normal)), 1, 1e-12);
    EXPECT_NEAR((other.point - plane.point).dot(plane.normal), 0, 1e-12);
  }
  const std::vector<Plane> without = planes_through(half, std::nullopt, std::nullopt);
  const std::vector<Plane> planes = planes_through(half, strained, std::nullopt);
  EXPECT_GE(without.size(), 2U);
  ASSERT_EQ(planes.size(), 2 * without.size());
  for (std::size_t i = 0; i < without.size(); ++i) {
    const Plane& parallel = planes[without.size() + i];
    EXPECT_EQ((parallel.point - strained).norm(), 0);
    EXPECT_EQ((parallel.normal - without[i].normal).norm(), 0);
  }
}

CutOptions up_to(double strain) {
  CutOptions cut_options;
  cut_options.strain = strain;
  return cut_options;
}

std::vector<DartProposal> smooth_sets(const FlattenInput& input, CutOptions cut_options = {}) {
  cut_options.is_smooth = true;
  return propose_seams(input, {}, cut_options, {});
}

std::vector<DartProposal> sets_of_parts(const FlattenInput& input, const CutOptions& cut_options) {
  const InternalOptions options{Options()};
  const SurfaceToCut surface(input, options);
  const ExactEvaluation exact(surface, options, StopToken());
  CutProgress progress(nullptr);
  const FlatPieces pieces = exact.uncut();
  return part_sets(pieces, 0, cut_options, exact, progress).sets;
}

TEST(PartSets, DivideAModelAtItsNeckAndClaimTheFiguresOfARun) {
  const FlattenInput input = dumbbell(20, 20);
  const std::vector<DartProposal> sets = smooth_sets(input, up_to(0.15));
  ASSERT_FALSE(sets.empty());
  for (const DartProposal& set : sets) {
    ASSERT_FALSE(set.paths.empty());
    test::expect_figures(input, set);
  }
  const FlattenInput cut = test::with_paths(input, sets.front().paths);
  for (const Piece& piece : flatten(cut).pieces) {
    double low = 0, high = 0;
    for (const int v : piece.source_vertex) {
      low = std::min(low, cut.vertices(v, 2));
      high = std::max(high, cut.vertices(v, 2));
    }
    EXPECT_LT(std::min(-low, high), 0.3);  // no piece reaches far into both balls
  }
}

TEST(PartSets, DivideRoundModelsWithoutNecks) {
  for (const FlattenInput& input : {test::closed_sphere(16, 12), test::closed_torus(20, 10)}) {
    const std::vector<DartProposal> sets = sets_of_parts(input, {});
    ASSERT_FALSE(sets.empty());
    for (const DartProposal& set : sets) {
      EXPECT_LE(set.num_pieces, 30);
      EXPECT_LE(set.strain, 0.2);
      EXPECT_FALSE(set.paths.empty());
      test::expect_figures(input, set);
    }
  }
}

TEST(PartSets, KeepTheBestOfTheFirstSetsIfNoneKeepsTheLimit) {
  const FlattenInput input = dumbbell(6, 4);  // its triangles are so large that no plane helps
  CutOptions cut_options = up_to(0.2);
  cut_options.is_smooth = true;
  const std::vector<DartProposal> sets = sets_of_parts(input, cut_options);
  ASSERT_FALSE(sets.empty());
  EXPECT_GT(sets.back().strain, *cut_options.strain);
  for (const DartProposal& set : sets) {
    EXPECT_FALSE(set.paths.empty());
    test::expect_figures(input, set);
  }
}

TEST(PartSets, LeaveTheSeamsOfAnOctahedronOnItsEdges) {
  const FlattenInput input =
      test::mesh_of({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
                    {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}});
  const std::vector<DartProposal> sets = smooth_sets(input);
  ASSERT_FALSE(sets.empty());
  for (const DartProposal& set : sets) {
    EXPECT_EQ(cut_mesh(input.vertices, input.faces, set.paths).vertices.rows(), input.vertices.rows());
  }
  EXPECT_LT(sets.front().strain, 1e-6);
  CutOptions one;
  one.count = 1;
  EXPECT_EQ(smooth_sets(input, one).size(), 1U);
}

TEST(PartSets, ListTheEdgesOfLinesAlongEdges) {
  FlattenInput input = test::closed_sphere(12, 8);
  for (auto p : input.vertices.rowwise()) p[2] /= 2;
  const std::vector<DartProposal> sets = sets_of_parts(input, up_to(0.4));
  ASSERT_EQ(sets.size(), 1U);
  EXPECT_EQ(sets[0].edges.size(), 12U) << "the set is not the equator";
  EXPECT_EQ(test::undirected(sets[0].edges), test::undirected(test::with_paths(input, sets[0].paths).seams));
}

TEST(PartSets, AreFollowedByOthersIfTheyNeedTooMuchStrain) {
  const FlattenInput input = dumbbell(10, 10);
  const std::vector<DartProposal> parts = sets_of_parts(input, up_to(0.03));
  ASSERT_FALSE(parts.empty());
  bool has_other = false;
  for (const DartProposal& set : smooth_sets(input, up_to(0.03))) {
    EXPECT_FALSE(set.paths.empty());
    test::expect_figures(input, set);
    has_other = has_other || std::none_of(parts.begin(), parts.end(),
                                          [&](const DartProposal& part) { return part.length == set.length; });
  }
  EXPECT_TRUE(has_other);
}

TEST(PartSets, DoNotDependOnHowTheModelIsGiven) {
  FlattenInput input = dumbbell(20, 20);
  // Makes the model asymmetric, so that no two planes are equally good.
  for (auto p : input.vertices.rowwise()) p << p[0] + 0.1 * p[1], 0.8 * p[1] * (1 + 0.1 * p[2]), p[2] + 0.15 * p[0];
  ASSERT_NE(input.vertices.rows() % 7, 0);
  const std::vector<DartProposal> sets = smooth_sets(input, up_to(0.15)),
                                  others = smooth_sets(test::disguised(input), up_to(0.15));
  ASSERT_FALSE(sets.empty());
  ASSERT_EQ(sets.size(), others.size());
  for (std::size_t i = 0; i < sets.size(); ++i) {
    EXPECT_EQ(sets[i].num_pieces, others[i].num_pieces);
    // Rounding errors may decide whether a point snaps to a vertex, and which triangle completes 99% of the area.
    EXPECT_NEAR(sets[i].length, others[i].length, 1e-3 * sets[i].length);
    EXPECT_NEAR(sets[i].strain, others[i].strain, 2e-3);
  }
}

VertexPairs edges_of(const FlattenInput& input, int face) {
  VertexPairs edges(3, 2);
  for (int k = 0; k < 3; ++k) edges.row(k) << input.faces(face, k), input.faces(face, (k + 1) % 3);
  return edges;
}

/// Returns the faces that share a corner with a face through which a path leads.
std::set<int> faces_touched(const FlattenInput& input, const DartProposal& set) {
  std::set<int> corners, touched;
  for (const SurfacePath& path : set.paths) {
    for (const int f : path.faces) corners.insert({input.faces(f, 0), input.faces(f, 1), input.faces(f, 2)});
  }
  for (int f = 0; f < input.faces.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      if (corners.count(input.faces(f, k)) > 0) touched.insert(f);
    }
  }
  return touched;
}

TEST(PartSets, DoNotEnterForbiddenFacesAndAreTheSameIfTheyAvoidThemAnyway) {
  const FlattenInput input = dumbbell(20, 20);
  CutOptions cut_options = up_to(0.15);
  const DartProposal first = smooth_sets(input, cut_options).front();
  const std::set<int> touched = faces_touched(input, first);
  int free = 0;
  while (touched.count(free) > 0) ++free;
  ASSERT_LT(free, input.faces.rows());
  cut_options.no_seam = cut_options.no_crossing = edges_of(input, free);
  const DartProposal same = smooth_sets(input, cut_options).front();
  EXPECT_EQ(same.num_pieces, first.num_pieces);
  EXPECT_DOUBLE_EQ(same.length, first.length);

  const std::vector<int>& crossed = first.paths.front().faces;
  const int entered = crossed[crossed.size() / 2];
  cut_options.no_seam = cut_options.no_crossing = edges_of(input, entered);
  const std::vector<DartProposal> sets = smooth_sets(input, cut_options);
  ASSERT_FALSE(sets.empty());
  for (const DartProposal& set : sets) {
    const CutMesh cut = cut_mesh(input.vertices, input.faces, set.paths);
    EXPECT_EQ(std::count(cut.sources.faces.begin(), cut.sources.faces.end(), entered), 1) << "the face is divided";
    const std::set<VertexPair> seams = test::undirected(test::with_paths(input, set.paths).seams);
    for (const VertexPair& edge : test::undirected(cut_options.no_seam)) EXPECT_EQ(seams.count(edge), 0U);
  }
}

TEST(PartSets, CanBeStopped) {
  const FlattenInput input = dumbbell(24, 24);
  CutOptions cut_options;
  cut_options.is_smooth = true;
  const auto stop = [](const std::string&, double fraction) { return fraction < 0.01; };
  EXPECT_THROW(propose_seams(input, {}, cut_options, stop), FlattenError);
}

}  // namespace
}  // namespace wirewarp::test_parts
