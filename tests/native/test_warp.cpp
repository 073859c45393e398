// SPDX-License-Identifier: GPL-3.0-or-later
// ψ(h), its exact gradient, and the lengths that make it least distorted.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "outer/choose_variation.h"
#include "test_meshes.h"

namespace wirewarp {
namespace {

constexpr double kFree = std::numeric_limits<double>::infinity();

/// A chart with its warp.
struct Case {
  explicit Case(const FlattenInput& input, NodeWeight weight = NodeWeight::length)
      : charts(test::charts_of(input)),
        chart(charts.charts[0]),
        network(build_wire_network(chart)),
        warp(chart, network, weight, Inner::minimum),
        bounds(variation_bounds(chart, Options{})) {}
  OuterSolution solve() {
    return choose_variation(chart, warp, bounds, [] {});
  }
  Charts charts;
  const Chart& chart;
  WireNetwork network;
  Warp warp;
  VariationBounds bounds;
};

/// Wires lines + lines across a lopsided dome, all with one tolerance.
FlattenInput dome(int n, int lines, double tolerance) {
  FlattenInput input = test::make_grid(n, n, [](double s, double t) {
    const double x = 2 * s - 1;
    const double y = 2 * t - 1;
    return Eigen::Vector3d(x, y, -0.4 * (x * x + y * y) - 0.15 * x * y * y);
  });
  for (int i = 1; i <= lines; ++i) {
    test::add_wire(input, test::grid_row(n, i * n / (lines + 1)), tolerance);
    test::add_wire(input, test::grid_column(n, n, i * n / (lines + 1)), tolerance);
  }
  return input;
}

TEST(Warp, GradientAgreesWithDifferences) {
  for (const NodeWeight weight : {NodeWeight::length, NodeWeight::uniform}) {
    Case c(dome(12, 2, 0.1), weight);
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

TEST(Warp, GradientCostsOneFactorizationHoweverManyWires) {
  for (const int lines : {1, 3, 5}) {
    Case c(dome(24, lines, 0.1));
    const WarpedShape shape = c.warp(Eigen::VectorXd::Zero(2 * lines));
    const int before = c.warp.inner_factorizations();
    c.warp.gradient(shape);
    EXPECT_EQ(c.warp.inner_factorizations() - before, 1);
  }
}

TEST(ChooseVariation, LowersTheEnergyWithinTheTolerance) {
  Case rigid(dome(12, 2, 0));
  const double rigid_error = rigid.solve().shape_error;
  double previous = rigid_error;
  Eigen::VectorXd h = Eigen::VectorXd::Zero(4);
  for (const double tolerance : {0.01, 0.03, 0.05, 0.1, kFree}) {
    Case c(dome(12, 2, tolerance));
    const OuterSolution solution = improve_variation(c.warp, c.bounds, h, [] {});
    EXPECT_TRUE(solution.converged);
    EXPECT_LE(solution.variation.cwiseAbs().maxCoeff(), tolerance);
    EXPECT_LE(solution.shape_error, previous * (1 + 1e-6)) << "raising the tolerance never raises E";
    EXPECT_LE(solution.evaluations, 40);
    previous = solution.shape_error;
    h = solution.variation;
  }
  EXPECT_LT(previous, 0.7 * rigid_error);
}

TEST(ChooseVariation, EndsNoHigherThanTheFreeFlatteningsLengths) {
  Case c(dome(12, 2, 0.05));
  const OuterSolution solution = c.solve();
  for (const double share : {0.0, 0.5, 1.0}) {
    const Eigen::VectorXd start = share * solution.variation;
    EXPECT_LE(solution.shape_error, c.warp.shape_error(c.warp(start)) * (1 + 1e-9));
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
  const OuterSolution as_rigid = choose_variation(elastic.chart, elastic.warp, rigid_bounds, [] {});
  Case rigid(dome(12, 2, 0));
  EXPECT_LT((as_rigid.shape.uv - rigid.solve().shape.uv).cwiseAbs().maxCoeff(), 1e-12);
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

TEST(ChooseVariation, AMirrorSymmetricMeshGivesAMirrorSymmetricPiece) {
  const int n = 12;
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
  test::add_wire(input, test::grid_row(n, 4), 0.05);
  test::add_wire(input, test::grid_column(n, n, n / 2), 0.05);
  const FlattenResult result = flatten(input);
  const Positions2& uv = result.pieces[0].vertices;
  // Mirrored: the same distances between all pairs in a row as between their mirror images.
  double worst = 0;
  for (int v = 0; v < uv.rows(); ++v) {
    const int mirror = v - v % (n + 1) + n - v % (n + 1);
    for (const int corner : {0, n, n * (n + 1), n * (n + 1) + n}) {
      const int mirror_corner = corner - corner % (n + 1) + n - corner % (n + 1);
      worst = std::max(worst,
                       std::abs((uv.row(v) - uv.row(corner)).norm() - (uv.row(mirror) - uv.row(mirror_corner)).norm()));
    }
  }
  EXPECT_LT(worst, 1e-6);
}

}  // namespace
}  // namespace wirewarp
