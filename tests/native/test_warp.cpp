// SPDX-License-Identifier: GPL-3.0-or-later
// ψ(h), its exact gradient, and the lengths that make it least distorted.
#include <gtest/gtest.h>

#include <cmath>
#include <exception>
#include <limits>
#include <optional>

#include "base/planar.h"
#include "energy/free_boundary_arap.h"
#include "numerics/optimize/active_set_bfgs.h"
#include "surface/mesh/geometry.h"
#include "test_meshes.h"
#include "warp/outer/choose_variation.h"
#include "warp/topology/process_topology.h"

namespace wirewarp::test_warp {
namespace {

constexpr double kFree = std::numeric_limits<double>::infinity();

/// A chart, with the helper wires it needs, and its warp.
struct Case {
  explicit Case(const FlattenInput& input, NodeWeight weight = NodeWeight::length)
      : charts(test::charts_of(input)),
        refined(process_topology(charts.charts[0])),
        chart(refined ? *refined : charts.charts[0]),
        network(build_wire_network(chart)),
        warp(chart, network, weight, Inner::minimum),
        bounds(variation_bounds(chart, Options{})) {}
  OuterSolution solve() { return choose_variation(chart, warp, bounds); }
  Eigen::VectorXd no_variation() const { return Eigen::VectorXd::Zero(bounds.lower.size()); }
  Charts charts;
  std::optional<Chart> refined;
  const Chart& chart;
  WireNetwork network;
  Warp warp;
  VariationBounds bounds;
};

Eigen::Vector3d lopsided_dome(double s, double t) {
  const double x = 2 * s - 1;
  const double y = 2 * t - 1;
  return {x, y, -0.4 * (x * x + y * y) - 0.15 * x * y * y};
}

/// Wires lines + lines across a lopsided dome, all with one tolerance.
FlattenInput dome(int n, int lines, double tolerance) {
  FlattenInput input = test::make_grid(n, n, lopsided_dome);
  for (int i = 1; i <= lines; ++i) {
    test::add_wire(input, test::grid_row(n, i * n / (lines + 1)), tolerance);
    test::add_wire(input, test::grid_column(n, n, i * n / (lines + 1)), tolerance);
  }
  return input;
}

/// A wire that touches nothing, and one that ends inside: helper wires lead on to the outline.
FlattenInput saddle_with_loose_wires(double tolerance) {
  const int n = 12;
  FlattenInput input = test::saddle(n, 0.4);
  const std::vector<int> row = test::grid_row(n, 4), column = test::grid_column(n, n, 9);
  test::add_wire(input, {row.begin() + 3, row.begin() + 8}, tolerance);
  test::add_wire(input, {column.begin(), column.begin() + 8}, tolerance);
  return input;
}

/// A dome with two holes: helper wires lead to them.
FlattenInput dome_with_two_holes(double tolerance) {
  FlattenInput input = test::flat_plate_with_two_holes(4);
  std::vector<int> across;
  for (int i = 0; i <= 8; ++i) across.push_back(test::nearest_vertex(input, {1.5, 0.25 * i, 0}));
  test::add_wire(input, across, tolerance);
  for (int v = 0; v < input.vertices.rows(); ++v) {
    const double x = input.vertices(v, 0) - 1.3;
    const double y = input.vertices(v, 1) - 0.8;
    input.vertices(v, 2) = 0.5 * std::exp(-x * x - y * y);
  }
  return input;
}

TEST(Warp, GradientAgreesWithDifferences) {
  for (const FlattenInput& input : {dome(12, 2, 0.1), saddle_with_loose_wires(0.1), dome_with_two_holes(0.1)}) {
    for (const NodeWeight weight : {NodeWeight::length, NodeWeight::uniform}) {
      Case c(input, weight);
      const auto n = static_cast<Eigen::Index>(c.chart.wire_parts.size());
      Eigen::VectorXd h(n);
      for (Eigen::Index i = 0; i < n; ++i) h[i] = 0.01 * std::sin(3.0 + 2 * static_cast<double>(i));
      const Eigen::VectorXd gradient = c.warp.gradient(c.warp(h));
      const double step = 1e-5;
      for (Eigen::Index i = 0; i < n; ++i) {
        const Eigen::VectorXd e = step * Eigen::VectorXd::Unit(n, i);
        const double difference = (c.warp.shape_error(c.warp(h + e)) - c.warp.shape_error(c.warp(h - e))) / (2 * step);
        EXPECT_NEAR(gradient[i], difference, 1e-6 * gradient.lpNorm<Eigen::Infinity>()) << "wire " << i;
      }
    }
  }
}

TEST(Warp, TheGaussNewtonHessianIsTheHessianWhereNothingIsDistorted) {
  FlattenInput flat = test::flat_rectangle(8, 6, 2, 1);
  for (const int i : {2, 4}) {
    test::add_wire(flat, test::grid_row(8, i), 0.1);
    test::add_wire(flat, test::grid_column(8, 6, i), 0.1);
  }
  Case c(flat);
  const std::vector<int> parts = c.bounds.elastic_parts();
  const auto n = static_cast<Eigen::Index>(parts.size());
  ASSERT_GE(n, 4);
  const Eigen::MatrixXd hessian = c.warp.gauss_newton_hessian(c.warp(c.no_variation()), parts);
  const double step = 1e-5, floor = 1e-3 * hessian.diagonal().mean();
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::VectorXd h = step * Eigen::VectorXd::Unit(n, i);
    const Eigen::VectorXd difference = c.warp.gradient(c.warp(h))(parts) - c.warp.gradient(c.warp(-h))(parts);
    EXPECT_LT((hessian.col(i) - difference / (2 * step)).lpNorm<Eigen::Infinity>(), floor) << "wire " << i;
  }
}

TEST(Warp, FollowingReachesTheSameShapeWithFewerFactorizations) {
  for (const FlattenInput& input : {dome(12, 2, 0.1), test::quarter_sphere(12), dome_with_two_holes(0.1)}) {
    Case c(input);
    const Eigen::VectorXd h = Eigen::VectorXd::LinSpaced(c.bounds.lower.size(), -0.02, 0.03);
    const WarpedShape start = c.warp(c.no_variation()), there = c.warp(h), followed = c.warp.follow(start, h);
    EXPECT_TRUE(followed.inner.is_minimum);
    EXPECT_LE(followed.inner.num_solves, there.inner.num_solves);
    EXPECT_NEAR(c.warp.shape_error(followed), c.warp.shape_error(there), 1e-9 * c.warp.shape_error(there));
  }
}

TEST(Warp, GradientCostsOneFactorizationHoweverManyWires) {
  for (const int lines : {1, 3, 5}) {
    Case c(dome(24, lines, 0.1));
    const WarpedShape shape = c.warp(Eigen::VectorXd::Zero(2 * lines));
    const int before = c.warp.inner_factorizations();
    c.warp.gradient(shape);
    EXPECT_EQ(c.warp.inner_factorizations() - before, 1);
  }
}

TEST(Warp, AsksBeforeEachFactorizationAndGoesNoFurther) {
  const Charts charts = test::charts_of(test::quarter_sphere(12));
  const Chart& chart = charts.charts[0];
  const WireNetwork network = build_wire_network(chart);
  int questions = 0, answers = std::numeric_limits<int>::max();
  const auto new_warp = [&] {
    return Warp(chart, network, NodeWeight::length, Inner::minimum,
                StopToken([&](const char*) { return ++questions <= answers; }));
  };
  Warp warp = new_warp();
  const int in_constructor = questions;
  const Eigen::VectorXd h = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(chart.wire_parts.size()));
  warp.gradient(warp(h));
  const int whole = questions;
  EXPECT_GE(whole, warp.inner_factorizations());
  for (answers = 0; answers < whole; ++answers) {
    questions = 0;
    if (answers < in_constructor) {
      EXPECT_THROW(new_warp(), Stopped);
      continue;
    }
    Warp stopped = new_warp();
    EXPECT_THROW(stopped.gradient(stopped(h)), Stopped);
    EXPECT_LE(stopped.inner_factorizations(), answers);
  }
}

void set_tolerance(FlattenInput& input, double tolerance) {
  for (Wire& wire : input.wires) wire.tolerance = tolerance;
}

/// The search from a given h, at which the shape is a minimum of Eq. (1).
BoxMinimum improve_from(Case& c, const Eigen::VectorXd& start) {
  const std::vector<int> parts = c.bounds.elastic_parts();
  const BoxFunction error_of = [&](const Eigen::VectorXd& elastic) -> std::optional<ValueAndGradient> {
    Eigen::VectorXd variation = start;
    variation(parts) = elastic;
    const WarpedShape shape = c.warp(variation);
    if (!shape.inner.is_minimum) return std::nullopt;
    return ValueAndGradient{c.warp.shape_error(shape), c.warp.gradient(shape)(parts)};
  };
  return minimize_in_box(error_of, c.bounds.lower(parts), c.bounds.upper(parts), start(parts), 1e-6, 40);
}

TEST(ChooseVariation, RaisingTheToleranceNeverRaisesTheEnergy) {
  for (FlattenInput input : {dome(12, 2, 0), test::quarter_sphere(12), saddle_with_loose_wires(0)}) {
    Case rigid(input);
    const OuterSolution start = rigid.solve();
    Eigen::VectorXd variation = start.variation;
    double before = start.shape_error;
    for (const double tolerance : {0.01, 0.03, 0.05, 0.1, kFree}) {
      set_tolerance(input, tolerance);
      Case c(input);
      const BoxMinimum minimum = improve_from(c, variation);
      EXPECT_TRUE(minimum.converged);
      variation(c.bounds.elastic_parts()) = minimum.x;
      for (std::size_t i = 0; i < input.wires.size(); ++i) {
        EXPECT_LE(std::abs(variation[static_cast<Eigen::Index>(i)]), tolerance);
      }
      EXPECT_LE(minimum.value, before * (1 + 1e-6)) << "at " << tolerance;
      before = minimum.value;
    }
    EXPECT_LT(before, 0.9 * start.shape_error);
  }
}

TEST(ChooseVariation, EndsNoHigherThanItsStart) {
  for (FlattenInput input : {dome(12, 2, 0), test::quarter_sphere(12), saddle_with_loose_wires(0)}) {
    for (const double tolerance : {0.03, kFree}) {
      set_tolerance(input, tolerance);
      Case c(input);
      const double end = c.solve().shape_error;
      const WarpedShape rigid = c.warp(c.no_variation());
      EXPECT_LE(end, c.warp.shape_error(rigid));
      // h0, by the test's own code: lengths in the free flattening, projected on the bounds.
      const Positions2 free = free_boundary_arap(c.chart, 30, rigid.uv).uv;
      Eigen::VectorXd h = c.no_variation();
      for (const int i : c.bounds.elastic_parts()) {
        double on_surface = 0, flat = 0;
        for (const HalfedgeHandle half_edge : c.chart.wire_parts[static_cast<std::size_t>(i)].half_edges) {
          on_surface += edge_length(c.chart.mesh, half_edge);
          flat += (free.row(c.chart.mesh.to_vertex_handle(half_edge).idx()) -
                   free.row(c.chart.mesh.from_vertex_handle(half_edge).idx()))
                      .norm();
        }
        h[i] = flat / on_surface - 1;
      }
      h = h.cwiseMax(c.bounds.lower).cwiseMin(c.bounds.upper);
      EXPECT_LE(end, c.warp.shape_error(c.warp(h)));
    }
  }
}

/// The outer side of a bent pipe, with a wire around every row.
FlattenInput half_tube(int rows) {
  FlattenInput input = test::make_grid(8, rows + 1, [](double s, double t) {
    const double around = 2 * (s - 0.5), along = 5 * t;
    const double radius = 3 + std::cos(around);
    return Eigen::Vector3d(std::sin(around), radius * std::sin(along), -radius * std::cos(along));
  });
  for (int j = 1; j <= rows; ++j) test::add_wire(input, test::grid_row(8, j), 0.05);
  return input;
}

TEST(ChooseVariation, TakesFewEvaluationsWithManyWires) {
  for (const FlattenInput& input : {dome(12, 5, 0.05), dome(16, 15, 0.05)}) {
    Case c(input);
    const OuterSolution solution = c.solve();
    EXPECT_TRUE(solution.converged);
    EXPECT_LE(solution.evaluations, 40) << input.wires.size() << " wires";
  }
  // Strips up to a hundred times as long as wide.
  for (const auto& [rows, most] : {std::pair(60, 10), std::pair(200, 30)}) {
    Case c(half_tube(rows));
    const OuterSolution solution = c.solve();
    EXPECT_TRUE(solution.converged);
    EXPECT_LE(solution.evaluations, most) << rows << " wires";
  }
}

/// A pyramid over a square of side 1; on one side of the square, the wire, stands a triangle whose other sides are
/// 0.505 long. No flat triangle has the wire longer than 1.01.
FlattenInput pyramid_beside_a_narrow_triangle() {
  const double low = std::sqrt(0.505 * 0.505 - 0.25);
  FlattenInput input;
  input.vertices.resize(6, 3);
  input.vertices << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0.5, 0.5, 0.6, 0.5, -low, 0;
  input.faces.resize(5, 3);
  input.faces << 0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4, 1, 0, 5;
  test::add_wire(input, {0, 1}, kFree);
  return input;
}

TEST(ChooseVariation, BacksOffFromLengthsThatCannotBeKept) {
  Case c(pyramid_beside_a_narrow_triangle());
  const auto at = [&](double h) { return c.warp(Eigen::VectorXd::Constant(1, h)); };
  ASSERT_FALSE(at(0.015).inner.is_feasible);
  ASSERT_LT(c.warp.gradient(at(0.0))[0], 0) << "the pyramid wants the wire longer";
  const OuterSolution solution = c.solve();
  EXPECT_TRUE(solution.shape.inner.is_minimum);
  EXPECT_GT(solution.variation[0], 0);
  EXPECT_LT(solution.variation[0], 0.01);
  EXPECT_LT(solution.shape_error, c.warp.shape_error(at(0.0)));
}

TEST(ChooseVariation, ATubeIsDoneWithLittleWork) {
  FlattenInput tube = test::make_tube(16, 6, [](double s, double t) {  // a sleeve, narrower and bent at the end
    const double angle = 2 * kPi * s, radius = 1 - 0.4 * t;
    return Eigen::Vector3d(radius * std::cos(angle) + 0.5 * t * t, radius * std::sin(angle), 3 * t);
  });
  test::add_wire(tube, test::tube_ring(16, 3), 0.05);
  for (const FlattenInput& input : {tube, test::cylinder_tube(16, 6, 1, 3), test::sphere_band(16, 6, 1)}) {
    Case c(input);
    const OuterSolution solution = c.solve();
    EXPECT_TRUE(solution.shape.inner.is_minimum);
    EXPECT_LT(solution.shape.inner.closure_residual, 1e-12);
    EXPECT_LT(solution.inner_solves, 40 * solution.evaluations);
  }
}

TEST(ChooseVariation, WireWarpingIsEveryToleranceZero) {
  Case elastic(dome(12, 2, 0.05));
  Options wirewarping;
  wirewarping.method = Method::wirewarping;
  const VariationBounds rigid_bounds = variation_bounds(elastic.chart, wirewarping);
  EXPECT_TRUE(rigid_bounds.elastic_parts().empty());
  Options least_norm;
  least_norm.inner = Inner::least_norm;
  EXPECT_TRUE(variation_bounds(elastic.chart, least_norm).elastic_parts().empty()) << "it has no gradient by h";
  const OuterSolution as_rigid = choose_variation(elastic.chart, elastic.warp, rigid_bounds);
  Case rigid(dome(12, 2, 0));
  EXPECT_LT((as_rigid.shape.uv - rigid.solve().shape.uv).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(ChooseVariation, HelperWiresStayFreeInWireWarping) {
  Options wirewarping;
  wirewarping.method = Method::wirewarping;
  Case free(saddle_with_loose_wires(kFree)), rigid(saddle_with_loose_wires(0));
  const OuterSolution as_rigid = choose_variation(free.chart, free.warp, variation_bounds(free.chart, wirewarping));
  const OuterSolution expected = rigid.solve();
  EXPECT_LT((as_rigid.variation - expected.variation).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT((as_rigid.shape.uv - expected.shape.uv).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_EQ(expected.variation.head(2).cwiseAbs().maxCoeff(), 0) << "the user's wires";
  EXPECT_GT(expected.variation.tail(3).cwiseAbs().minCoeff(), 1e-6);
  EXPECT_LT(expected.shape_error, rigid.warp.shape_error(rigid.warp(rigid.no_variation())));
}

TEST(ChooseVariation, LengthsFollowTheirVariationExactly) {
  Case c(dome(12, 2, 0.05));
  const OuterSolution solution = c.solve();
  for (const WireEdge& edge : c.network.edges) {
    const HalfedgeHandle h = c.chart.mesh.halfedge_handle(edge.edge, 0);
    const double length = (solution.shape.uv.row(c.chart.mesh.to_vertex_handle(h).idx()) -
                           solution.shape.uv.row(c.chart.mesh.from_vertex_handle(h).idx()))
                              .norm();
    const double variation = edge.part >= 0 ? solution.variation[edge.part] : 0;
    EXPECT_NEAR(length, (1 + variation) * edge.length, 1e-9 * edge.length);
  }
}

/// A mirror-symmetric dome, triangles included, with a wire across the plane of symmetry and one in it.
FlattenInput symmetric_dome(int n, double tolerance) {
  FlattenInput input = test::make_grid(n, n, [](double s, double t) {
    const double x = 2 * s - 1;
    const double y = 2 * t - 1;
    return Eigen::Vector3d(x, y, -0.3 * (x * x + y * y + 0.4 * y * y * y));
  });
  for (int f = 0; f < input.faces.rows(); f += 2) {  // the right half's diagonals the other way: triangles mirror too
    const int quad = f / 2;
    const int i = quad % n;
    if (2 * i < n) continue;
    const int a = i + (n + 1) * (quad / n);
    input.faces.row(f) << a, a + 1, a + n + 1;
    input.faces.row(f + 1) << a + 1, a + n + 2, a + n + 1;
  }
  test::add_wire(input, test::grid_row(n, 4), tolerance);
  test::add_wire(input, test::grid_column(n, n, n / 2), tolerance);
  return input;
}

TEST(ChooseVariation, AMirrorSymmetricMeshGivesAMirrorSymmetricPiece) {
  const int n = 12;
  const auto mirrored = [](int v) { return v - v % (n + 1) + n - v % (n + 1); };
  for (const double tolerance : {0.0, 0.01, 0.05, kFree}) {
    const FlattenResult result = flatten(symmetric_dome(n, tolerance));
    const Positions2& uv = result.pieces[0].vertices;
    for (int v = 0; v < uv.rows(); ++v) {  // as far from each corner as its mirror image from the mirrored corner
      for (const int corner : {0, n, n * (n + 1), n * (n + 1) + n}) {
        const double distance = (uv.row(v) - uv.row(corner)).norm();
        EXPECT_NEAR(distance, (uv.row(mirrored(v)) - uv.row(mirrored(corner))).norm(), 1e-6);
      }
    }
  }
}

}  // namespace
}  // namespace wirewarp::test_warp
