// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of fixed faults of slits, which are seams inside one piece. A slit has two rims. If it has only one edge, both
// rims connect the same two vertices.
#include "surface/charts/slits.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>
#include <string>

#include "base/planar.h"
#include "energy/fair_shape_error.h"
#include "newton/refine_chart.h"
#include "processed_chart.h"
#include "surface/mesh/geometry.h"
#include "test_meshes.h"
#include "warp/inner/kkt_system.h"
#include "wirewarp/cache.h"

namespace wirewarp::bugs_of_slits_test {
namespace {

// A piece with a hole got the cached shape of a piece of equal geometry with a slit. The key of the cache did not say
// which rims come from the same edges.

constexpr int kQuads = 8;

int vertex(int i, int j) { return i + (kQuads + 1) * j; }

FlattenInput dome() {
  return test::make_grid(kQuads, kQuads, [](double s, double t) {
    const double x = 2 * s - 1, y = 2 * t - 1;
    return Eigen::Vector3d(x, y, 0.5 * (1 - x * x) * (1 - y * y));
  });
}

FlattenInput with_slit() {
  FlattenInput input = dome();
  test::add_seam(input, test::grid_row(kQuads, 4));
  input.seams = input.seams.middleRows(2, 4).eval();  // from the third vertex of the row to the seventh
  return input;
}

/// Returns the dome with a hole at the place of the slit. As in flatten(), the slit's inner vertices are doubled. The
/// lower rim of the hole is sewn to a second piece.
FlattenInput with_sewn_hole() {
  const FlattenInput whole = dome();
  FlattenInput input;
  const auto is_doubled = [](int v) { return v > vertex(2, 4) && v < vertex(6, 4); };
  std::vector<int> number;  // new index of each vertex, or of the first of its two copies
  int count = 0;
  for (int v = 0; v < whole.vertices.rows(); ++v) {
    number.push_back(count);
    count += is_doubled(v) ? 2 : 1;
  }
  const int tip_of_flap = count;
  input.vertices.resize(count + 1, 3);
  for (int v = 0; v < whole.vertices.rows(); ++v) {
    input.vertices.row(number[v]) = whole.vertices.row(v);
    if (is_doubled(v)) input.vertices.row(number[v] + 1) = whole.vertices.row(v);
  }
  input.vertices.row(tip_of_flap) << 0, 0, 2;
  input.faces = whole.faces.unaryExpr([&](int v) { return number[v]; });
  const int first_above = 2 * kQuads * 4;  // index of the first face beyond the middle row
  for (int f = first_above; f < input.faces.rows(); ++f) {
    for (int k = 0; k < 3; ++k) input.faces(f, k) += is_doubled(whole.faces(f, k)) ? 1 : 0;
  }
  const Eigen::Index num_faces = input.faces.rows();
  input.faces.conservativeResize(num_faces + 4, 3);
  for (int i = 0; i < 4; ++i) {
    const int a = number[vertex(2 + i, 4)], b = number[vertex(3 + i, 4)];
    input.faces.row(num_faces + i) << a, b, tip_of_flap;
    test::add_seam(input, {a, b});
  }
  return input;
}

TEST(Bugs, ACachedSlitIsNotReusedForAHoleOfTheSameGeometry) {
  const FlattenInput sewn = with_sewn_hole();
  const FlattenResult alone = flatten(sewn);
  Cache cache;
  flatten(with_slit(), {}, {}, &cache);
  const FlattenResult cached = flatten(sewn, {}, {}, &cache);
  EXPECT_EQ(cached.reused_pieces, 0);
  EXPECT_TRUE(cached.corner_uv == alone.corner_uv);
}

// For domes with a slit of two or three edges, the solver did not converge, or the rims crossed. The cause was that
// exact shapes form several branches, which meet at a closed slit.

/// Direction of a slit on the grid. corner: along a row first, then along a column.
enum class Way { along_row, along_column, diagonal, corner };

std::vector<int> slit(int n, Way way, int num_edges) {
  int i = n / 2 - num_edges / 2, j = n / 2;
  std::vector<int> chain{i + (n + 1) * j};
  for (int step = 0; step < num_edges; ++step) {
    const bool turned = way == Way::corner && step >= (num_edges + 1) / 2;
    i += way == Way::along_column || turned ? 0 : 1;
    j += way == Way::along_column || way == Way::diagonal || turned ? 1 : 0;
    chain.push_back(i + (n + 1) * j);
  }
  return chain;
}

FlattenInput dome(int n, double height) {
  return test::make_grid(
      n, n, [&](double s, double t) { return Eigen::Vector3d(s, t, height * (s * (1 - s) + t * (1 - t))); });
}

/// Returns the objective f of the best shape with all slits closed, divided by the surface area.
double shut_objective(const FlattenInput& input, const Options& options) {
  const Chart chart = test::chart_of(input);
  const SewnChart sewn = *sew(chart, find_slits(chart));
  const Solution shut = refine_chart(sewn.chart, options);
  EXPECT_TRUE(shut.is_exact() && shut.is_converged());
  const FairShapeError objective(chart, build_held_network(chart), options.fairness);
  return objective.value(shut.shape.uv(sewn.vertex, Eigen::all)) / surface_area(chart.mesh);
}

TEST(Bugs, ClosedSlitsOfAFewEdgesTakeHardlyLongerThanWires) {
  for (const int n : {12, 20}) {
    for (const double fairness : {0.1, 0.3}) {
      for (const Way way : {Way::along_row, Way::along_column, Way::diagonal, Way::corner}) {
        for (int num_edges = 1; num_edges <= 6; ++num_edges) {
          SCOPED_TRACE(std::to_string(n) + " x " + std::to_string(n) + ", " + std::to_string(num_edges) +
                       " edges, way " + std::to_string(static_cast<int>(way)) + ", fairness " +
                       std::to_string(fairness));
          FlattenInput input = dome(n, 0.3);
          test::add_seam(input, slit(n, way, num_edges));
          Options options;
          options.fairness = fairness;
          const Piece piece = flatten(input, options).pieces.at(0);
          EXPECT_FALSE(piece.error) << piece.error->what();
          EXPECT_EQ(piece.report.termination, Termination::converged);
          EXPECT_LE(piece.report.factorizations, 20);
          EXPECT_LE(piece.report.objective, shut_objective(input, options) * (1 + 1e-9));
        }
      }
    }
  }
}

// A slit that turns more to the left than the outline was mistaken for the outer loop. As a result, a value was written
// at index -1.

/// Returns a sheet with two slits of one edge each. One slit connects two high spikes, so it turns by nearly 2 pi.
FlattenInput rough_sheet_with_two_slits() {
  FlattenInput input = test::make_grid(6, 6, [](double s, double t) {
    const bool is_spike = std::abs(s - 0.5) < 1e-9 && (std::abs(t - 0.5) < 1e-9 || std::abs(t - 1.0 / 3) < 1e-9);
    const bool is_corner = (s == 0 || s == 1) && (t == 0 || t == 1);
    return Eigen::Vector3d(s, t, is_spike ? 20 : is_corner ? 0.3 : 0);
  });
  test::add_seam(input, {3 + 7 * 2, 3 + 7 * 3});  // connects both spikes
  test::add_seam(input, {1 + 7 * 5, 2 + 7 * 5});
  return input;
}

TEST(Bugs, TheOuterLoopIsNotASlit) {
  const FlattenInput input = rough_sheet_with_two_slits();
  const Chart chart = test::charts_of(input).charts.at(0);
  ASSERT_EQ(chart.boundary_loops.size(), 3U);
  EXPECT_EQ(chart.boundary_loops[0].size(), 24U);  // the outline of 6 by 6 quads
  EXPECT_EQ(find_slits(chart).size(), 2U);
  EXPECT_EQ(flatten(input).pieces.size(), 1U);
}

TEST(Bugs, TheOutlineOfAClosedSurfaceWithTwoSlitsIsOneOfThem) {
  FlattenInput input = test::make_tube(
      6, 2, [](double s, double t) { return Eigen::Vector3d(std::cos(2 * kPi * s), std::sin(2 * kPi * s), t); });
  const int bottom = 18, top = 19;
  input.vertices.conservativeResize(20, 3);
  input.vertices.bottomRows(2) << 0, 0, -1, 0, 0, 2;
  const Eigen::Index num_faces = input.faces.rows();
  input.faces.conservativeResize(num_faces + 12, 3);
  for (int i = 0; i < 6; ++i) {
    const int next = (i + 1) % 6;
    input.faces.row(num_faces + 2 * i) << bottom, next, i;
    input.faces.row(num_faces + 2 * i + 1) << top, 12 + i, 12 + next;
  }
  test::add_seam(input, {6, 7});
  test::add_seam(input, {9, 10});
  const FlattenResult result = flatten(input);
  ASSERT_EQ(result.pieces.size(), 1U);
  EXPECT_TRUE(result.pieces[0].error) << "the outline has no area";
}

// The search for cuts mistook a slit of one edge for a sewn edge, because both rims connect the same two vertices. So
// the search suggested a cut along the slit itself.
TEST(Bugs, NoSeamIsProposedAlongASlitOfOneEdge) {
  const int around = 4;
  FlattenInput input = test::make_tube(around, 8, [](double s, double t) {
    return Eigen::Vector3d(std::cos(2 * kPi * s), std::sin(2 * kPi * s), 8 * t);
  });
  for (int row = 1; row < 7; ++row) {
    const int below = row * around, above = below + around;
    FlattenInput slit = input;
    test::add_seam(slit, {below, above});
    const FlattenResult result = flatten(slit);
    ASSERT_TRUE(result.pieces.at(0).error) << row;
    const std::vector<VertexPair>& proposed = result.pieces[0].error->elements.proposed_seams;
    EXPECT_FALSE(proposed.empty()) << row;
    for (const VertexPair& seam : proposed) {
      EXPECT_NE((std::set<int>{seam[0], seam[1]}), (std::set<int>{below, above})) << row;
    }
  }
}

// In a large piece, coarsening confused both rims of a slit of one edge, and read past the end of a rim's vertices.
TEST(Bugs, ALargePieceMayHaveASlitOfOneEdge) {
  const int n = 104;
  FlattenInput input = test::make_grid(
      n, n, [](double s, double t) { return Eigen::Vector3d(s, t, 0.3 * (s * (1 - s) + t * (1 - t))); });
  const int middle = test::nearest_vertex(input, {0.5, 0.5, 0.15});
  test::add_seam(input, {middle, middle + 1});
  Options options;
  options.fairness = 0.3;
  options.max_factorizations = 1;
  const FlattenResult result = flatten(input, options);
  ASSERT_EQ(result.pieces.size(), 1U);
  EXPECT_FALSE(result.pieces[0].error) << result.pieces[0].error->what();
  EXPECT_EQ(result.seams.at(0).mismatch, 0);
}

// At an end of the slit, the previous and the next vertex of the outline are one vertex. The Hessian of the fairness
// lacked the product of the derivatives for both, so the solver used all 100 factorizations.
TEST(Bugs, ASlitOfOneEdgeTakesNoLongerThanAWire) {
  const auto saddle = [](double s, double t) {
    return Eigen::Vector3d(68 * s, 5 * t, 8.5 * ((s - 0.5) * (s - 0.5) - (t - 0.5) * (t - 0.5)));
  };
  FlattenInput input = test::make_grid(4, 5, saddle);
  test::add_seam(input, {18, 23});
  const FlattenResult result = flatten(input);
  ASSERT_FALSE(result.pieces.at(0).error);
  EXPECT_EQ(result.pieces[0].report.termination, Termination::converged);
  EXPECT_LE(result.pieces[0].report.factorizations, 5);
}

// The two closure conditions of a slit of one edge depend on each other, so their pivot is regularized. The
// regularization was scaled by the mean weight, and was lost in rounding beside tiny edges.
TEST(Bugs, ASlitOfOneEdgeBesideTinyEdgesHasAFactor) {
  const int n = 12;
  for (int i = 0; i < 3 * (n - 2); ++i) {
    const int slit = i / 3, begin = n + 2 + slit;
    const int end = std::array{begin + 1, begin + n + 1, begin + n + 2}[static_cast<std::size_t>(i % 3)];
    const auto graded = [](double s, double t) {  // x falls from 1 to 3^-16
      return Eigen::Vector3d(std::pow(3, -16 * s), t, 0.3 * t * t);
    };
    FlattenInput input = test::make_grid(n, 3, graded);
    test::add_seam(input, {begin, end});  // along an axis, where one closure condition vanishes, or diagonally
    const Chart chart = test::process(input).refined;
    const WireNetwork network = build_wire_network(chart);
    const Eq1 eq1(network, NodeWeight::length);
    const Eigen::VectorXd psi = Eigen::VectorXd::Zero(eq1.num_edges());
    Eigen::VectorXd lengths(eq1.num_edges());
    for (int e = 0; e < lengths.size(); ++e) lengths[e] = network.edges[e].length;
    KktSystem system(eq1, network);
    EXPECT_TRUE(system.factor(eq1.laplacian(), psi, eq1.closure_jacobian(psi, lengths))) << begin << ' ' << end;
  }
}

}  // namespace
}  // namespace wirewarp::bugs_of_slits_test
