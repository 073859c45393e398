// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of coarse charts, and of fine shapes that start from coarse shapes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <set>

#include "base/planar.h"
#include "energy/shape_error.h"
#include "newton/coarse_start.h"
#include "newton/coarsen/prolong.h"
#include "newton/coarsen/prolong_wires.h"
#include "newton/minimize.h"
#include "newton/refine_chart.h"
#include "surface/mesh/geometry.h"
#include "test_meshes.h"

namespace wirewarp::test_coarsen {
namespace {

using test::jittered_grid;

Eigen::Vector3d flat(double s, double t) { return {2 * s, 2 * t, 0}; }

Eigen::Vector3d dome(double s, double t) {
  const double x = 2 * s - 1, y = 2 * t - 1;
  return {x, y, -0.3 * (x * x + y * y) + 0.05 * std::sin(5 * x + 2 * y)};
}

FlattenInput crossed(int n, double jitter, const test::Surface& surface = dome, double tolerance = 0) {
  FlattenInput input = jittered_grid(n, jitter, surface);
  test::add_wire(input, test::grid_row(n, n / 2), tolerance);
  test::add_wire(input, test::grid_column(n, n, n / 3), tolerance);
  return input;
}

struct Coarse {
  explicit Coarse(const FlattenInput& input, double stride = 4)
      : chart(test::chart_of(input)),
        coarse(coarsen(chart, network,
                       stride * std::sqrt(2 * surface_area(chart.mesh) / static_cast<double>(chart.mesh.n_faces())))) {}

  Chart chart;
  HeldNetwork network = build_held_network(chart);
  CoarseChart coarse;
};

Solution refine_from_scratch(Problem& problem) {
  InternalOptions options;
  options.large_chart = std::numeric_limits<std::size_t>::max();
  Budget budget(100);
  return refine_chart(problem, options, {budget});
}

TEST(Coarsen, RemovesMostVertices) {
  const Coarse c(crossed(40, 0.3));
  EXPECT_LT(10 * c.coarse.chart.mesh.n_faces(), c.chart.mesh.n_faces());
  EXPECT_GT(c.coarse.chart.mesh.n_faces(), 50u);
}

TEST(Coarsen, StopsWhenAsked) {
  const Coarse c(crossed(40, 0.3));
  int rounds = 0;
  EXPECT_THROW(coarsen(c.chart, c.network, 0.2, StopToken([&](const char*) { return rounds++ < 1; })), Stopped);
  EXPECT_EQ(rounds, 2);
}

TEST(Coarsen, RunsPartitionTheFineEdgesAndTheirLengths) {
  const Coarse c(crossed(40, 0.3));
  std::vector<int> count(c.network.edges.size(), 0);
  double walked = 0, total = 0;
  for (const WireRun& run : c.coarse.runs) {
    walked += run.walked_length;
    for (const WireHalfEdge h : run.half_edges) ++count[h.edge];
  }
  for (const WireEdge& edge : c.network.edges) total += edge.length;
  EXPECT_EQ(std::count(count.begin(), count.end(), 1), static_cast<std::ptrdiff_t>(count.size()));
  EXPECT_NEAR(walked, total, 1e-12 * total);
}

TEST(Coarsen, ChordsAndAnglesAreThoseOfTheCoarseMeshOnAPlane) {
  const Coarse c(crossed(40, 0.3, flat));
  const HeldNetwork measured = build_held_network(c.coarse.chart);
  for (std::size_t e = 0; e < measured.edges.size(); ++e) {
    EXPECT_NEAR(c.coarse.network.edges[e].length, measured.edges[e].length, 1e-12);
  }
  for (std::size_t i = 0; i < measured.nodes.size(); ++i) {
    EXPECT_NEAR(c.coarse.network.nodes[i].surface_angle, measured.nodes[i].surface_angle, 1e-10);
  }
}

TEST(Coarsen, KeepsTheTurningOfTheNetworkOnACurvedSurface) {
  const Coarse c(crossed(40, 0.3));
  const auto turning = [](const WireNetwork& network) {
    double sum = 0;
    for (const WireNode& node : network.nodes) sum += kPi - node.surface_angle;
    return sum;
  };
  EXPECT_NEAR(turning(c.coarse.network), turning(c.network), 1e-9);
}

TEST(Coarsen, ClosedWiresStayOpen) {
  const int n = 40;
  FlattenInput input = jittered_grid(n, 0.3, dome);
  test::add_wire(input, test::grid_square(n, 21, 21, 1));
  const Coarse c(input, 12);
  const HalfEdgeChain& ring = c.coarse.chart.wire_parts.at(0).half_edges;
  EXPECT_GE(ring.size(), 3u);
  std::set<int> edges;
  for (const HalfedgeHandle h : ring) edges.insert(c.coarse.chart.mesh.edge_handle(h).idx());
  EXPECT_EQ(edges.size(), ring.size());
}

Positions2 mapped(const HalfEdgeMesh& mesh, const std::function<Eigen::Vector2d(const Eigen::Vector2d&)>& map) {
  Positions2 uv(mesh.n_vertices(), 2);
  for (const VertexHandle v : mesh.vertices()) uv.row(v.idx()) = map({mesh.point(v)[0], mesh.point(v)[1]}).transpose();
  return uv;
}

/// On a quadratic map, linear interpolation in triangles of size h has the error h²/8 times the second derivative.
/// The error of interpolate() must be much smaller.
TEST(Prolong, FollowsQuadraticMaps) {
  const double bend = 0.01;
  const Coarse c(jittered_grid(40, 0.3, flat));
  const auto map = [&](const Eigen::Vector2d& p) -> Eigen::Vector2d {
    return p + bend * Eigen::Vector2d(p.x() * p.x() - p.x() * p.y(), p.y() * p.y() + p.x() * p.y());
  };
  const Positions2 coarse_uv = mapped(c.coarse.chart.mesh, map), wanted = mapped(c.chart.mesh, map);
  const Positions2 uv = interpolate(c.chart, c.coarse, coarse_uv);
  double error = 0, linear = 0;
  for (const VertexHandle v : c.chart.mesh.vertices()) {
    const CoarsePlace& place = c.coarse.places[v.idx()];
    const auto p = c.chart.mesh.point(v);
    // Near the outline, derivatives are one-sided and therefore less accurate.
    if (std::max(std::abs(p[0] - 1), std::abs(p[1] - 1)) > 0.8) continue;
    Eigen::RowVector2d flat_place(0, 0);
    for (int k = 0; k < 3; ++k) flat_place += place.weights[k] * coarse_uv.row(place.vertices[k]);
    linear += (flat_place - wanted.row(v.idx())).squaredNorm();
    error += (uv.row(v.idx()) - wanted.row(v.idx())).squaredNorm();
  }
  EXPECT_LT(error, 0.1 * linear);
}

/// Some triangles of the sheet are folded over their neighbors, and a smooth map keeps these folds.
TEST(Prolong, FlipsNoTriangleOfAJitteredSheet) {
  const Coarse c(crossed(72, 0.32));
  Problem coarse_problem(c.coarse.chart, c.coarse.network, 0.3);
  const Positions2 coarse_uv = refine_from_scratch(coarse_problem).shape.uv;
  Positions2 smooth = interpolate(c.chart, c.coarse, coarse_uv);
  prolong_wires(c.chart, c.network, c.coarse, coarse_uv, smooth);
  EXPECT_GT(ShapeError(c.chart).count_flips(smooth), 0);
  const Positions2 uv = prolong_positions(c.chart, c.network, c.coarse, coarse_uv);
  EXPECT_EQ(ShapeError(c.chart).count_flips(uv), 0);
  EXPECT_LT(((uv - smooth).rowwise().norm().array() > 0).count(), uv.rows() / 10) << "most vertices stay";
}

void expect_same_minimum(const FlattenInput& input, double fairness = 0.3, int max_factorizations = 2) {
  const Chart chart = test::chart_of(input);
  Problem problem(chart, fairness);
  Budget coarse_budget(100), budget(100);
  const std::optional<Shape> start = start_from_coarse(problem, {coarse_budget});
  ASSERT_TRUE(start);
  const Solution found = minimize(problem, {}, *start, {budget});
  const Solution from_scratch = refine_from_scratch(problem);
  EXPECT_TRUE(found.is_exact());
  EXPECT_TRUE(found.is_converged());
  EXPECT_LT(found.length_error, 1e-12);
  EXPECT_LE(found.factorizations, max_factorizations);
  EXPECT_NEAR(found.objective, from_scratch.objective, 1e-9 * from_scratch.objective);
}

TEST(CoarseStart, ReachesTheSameMinimum) {
  expect_same_minimum(crossed(48, 0.1, dome, 0.03));
  expect_same_minimum(crossed(64, 0.25, dome, 0.05));     // with jagged wires
  expect_same_minimum(test::quarter_sphere(40), 0.1, 3);  // far from developable: 13 factorizations from scratch
  FlattenInput plate = test::flat_plate_with_two_holes(24);
  for (int v = 0; v < plate.vertices.rows(); ++v) {
    plate.vertices(v, 2) = 0.2 * std::sin(2 * plate.vertices(v, 0)) * std::cos(1.5 * plate.vertices(v, 1));
  }
  expect_same_minimum(plate);
}

TEST(CoarseStart, LargeChartsTakeOneFactorization) {
  const Chart chart = test::chart_of(crossed(104, 0.2));  // 21,632 faces
  int asked = 0;
  const Solution refined = refine_chart(chart, Options{}, StopToken([&](const char*) { return ++asked > 0; }));
  EXPECT_TRUE(refined.is_converged());
  EXPECT_EQ(refined.factorizations, 1);
  EXPECT_GE(asked, refined.factorizations);
}

TEST(CoarseStart, StopsWhenAsked) {
  InternalOptions options;
  options.large_chart = 1;
  options.fairness = 0.3;
  const Chart chart = test::chart_of(crossed(16, 0.2));
  int asked = 0;
  refine_chart(chart, options, StopToken([&](const char*) { return ++asked > 0; }));
  bool was_exact = false;
  for (int last = 0; last < asked; ++last) {  // also cancels while the coarse chart is solved
    int count = 0;
    const StopToken stop([&](const char*) { return ++count <= last; });
    const Solution stopped = refine_chart(chart, options, stop);
    EXPECT_TRUE(stopped.is_exact() ? stopped.length_error < 1e-10 : stopped.status == SolutionStatus::cancelled);
    EXPECT_TRUE(stopped.is_exact() || !was_exact) << "a run that stops later must not lose exact lengths";
    was_exact = stopped.is_exact();
    EXPECT_TRUE(stop.is_stopped());
    EXPECT_EQ(count, last + 1);
  }
  EXPECT_TRUE(was_exact);
}

/// Every edge of a curved surface is rigid, so the coarse chart equals the fine chart and has no flat shape.
TEST(CoarseStart, IsRejectedIfTheCoarseChartHasNoExactLengths) {
  FlattenInput input = test::quarter_sphere(5);
  input.wires.clear();
  test::add_wires_on_edges(input);
  const Chart chart = test::chart_of(input);
  Budget budget(100);
  EXPECT_FALSE(start_from_coarse({chart, 1}, {budget}));
}

/// With little fairness, wires may have waves of a few edges, which a coarser chart cannot represent.
TEST(CoarseStart, IsRejectedIfWiresMayHaveShortWaves) {
  const Chart chart = test::chart_of(crossed(24, 0.2));
  Budget budget(100);
  EXPECT_FALSE(start_from_coarse({chart, 0.01}, {budget}));
}

/// The start has multipliers, as if it were near the minimum, but all its vertices coincide.
TEST(Minimize, RejectsAStartThatIsNotNearTheMinimum) {
  const Chart chart = test::chart_of(crossed(24, 0.2));
  const Problem problem(chart, 0.1);
  const Positions2 point = Positions2::Constant(chart.mesh.n_vertices(), 2, 1.0);
  Budget budget(100);
  const Eigen::VectorXd forces = Eigen::VectorXd::Ones(problem.network().edges.size());
  const Solution found = minimize(problem, {}, {point, {}, forces}, {budget});
  EXPECT_FALSE(found.is_exact());
}

}  // namespace
}  // namespace wirewarp::test_coarsen
