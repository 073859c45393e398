// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "base/planar.h"
#include "test_meshes.h"
#include "warp/topology/straightest_geodesic.h"

namespace wirewarp::test_straightest_geodesic {
namespace {

/// Where each vertex of a grid lies in the unrolled plane.
using Unroll = std::function<Planar(int column, int row)>;

/// A trace from a grid vertex, and how far its points lie from the straight line in the unrolled plane.
struct UnrolledTrace {
  double length = 0;        // unrolled, from the start to the last point
  double largest_miss = 0;  // from the line
  std::size_t num_points = 0;
};

UnrolledTrace trace_unrolled(const FlattenInput& input, int nx, int column, int row, double heading,
                             const Unroll& unroll) {
  const Charts charts = test::charts_of(input);
  const HalfEdgeMesh& mesh = charts.charts[0].mesh;
  const WireMask wires(charts.charts[0]);
  const auto plane = [&](VertexHandle v) { return unroll(v.idx() % (nx + 1), v.idx() / (nx + 1)); };
  const VertexHandle start(column + (nx + 1) * row);
  const HalfedgeHandle reference = mesh.find_halfedge(start, VertexHandle(start.idx() + 1));
  const Planar direction = std::polar(1.0, heading);
  double angle = std::arg(direction / (plane(VertexHandle(start.idx() + 1)) - plane(start)));
  if (angle < 0) angle += 2 * kPi;
  const auto path = trace_straightest(mesh, wires, reference, angle);
  UnrolledTrace result;
  if (!path) return result;
  result.num_points = path->size();
  for (const PathPoint& point : *path) {
    Planar p;
    if (point.is_vertex()) {
      p = plane(point.vertex);
    } else {
      const Planar from = plane(mesh.from_vertex_handle(point.half_edge));
      p = from + point.t * (plane(mesh.to_vertex_handle(point.half_edge)) - from);
    }
    result.largest_miss = std::max(result.largest_miss, std::abs(cross(direction, p - plane(start))));
    result.length = std::real(std::conj(direction) * (p - plane(start)));
  }
  return result;
}

TEST(StraightestGeodesic, IsAStraightLineOnThePlane) {
  const int n = 20;
  const FlattenInput input = test::flat_rectangle(n, n, 1, 1);
  const auto identity = [&](int i, int j) { return Planar(double(i) / n, double(j) / n); };
  for (double heading = 0.1; heading < 2 * kPi; heading += 0.37) {
    const UnrolledTrace trace = trace_unrolled(input, n, 10, 10, heading, identity);
    EXPECT_GT(trace.num_points, 10u) << heading;
    EXPECT_LT(trace.largest_miss, 1e-13) << heading;
    // From the center to the rim of the unit square.
    EXPECT_NEAR(trace.length, 0.5 / std::max(std::abs(std::cos(heading)), std::abs(std::sin(heading))), 1e-12);
  }
}

TEST(StraightestGeodesic, RunsThroughVerticesAndAlongEdges) {
  const int n = 8;
  const FlattenInput input = test::flat_rectangle(n, n, 1, 1);
  const auto identity = [&](int i, int j) { return Planar(double(i) / n, double(j) / n); };
  for (int k = 0; k < 8; ++k) {
    const UnrolledTrace trace = trace_unrolled(input, n, 4, 4, k * kPi / 4, identity);
    EXPECT_LT(trace.largest_miss, 1e-13) << k;
    EXPECT_NEAR(trace.length, k % 2 == 0 ? 0.5 : std::sqrt(0.5), 1e-12);
    // Against the diagonals of the quads it crosses one in each.
    EXPECT_EQ(trace.num_points, k == 3 || k == 7 ? 9u : 5u) << k;
  }
}

TEST(StraightestGeodesic, UnrollsToALineOnACylinder) {
  const int n = 60;
  const double angle = 5;
  const FlattenInput input = test::cylinder_patch(n, n, 2, angle, 7);
  const double chord = 2 * 2 * std::sin(angle / n / 2);  // the mesh is a prism
  const auto unroll = [&](int i, int j) { return Planar(chord * i, 7.0 * j / n); };
  for (double heading = 0.05; heading < 2 * kPi; heading += 0.51) {
    const UnrolledTrace trace = trace_unrolled(input, n, 25, 31, heading, unroll);
    EXPECT_GT(trace.num_points, 20u) << heading;
    EXPECT_LT(trace.largest_miss, 1e-10) << heading;
  }
}

TEST(StraightestGeodesic, UnrollsToALineOnACone) {
  const int n = 60;
  const double angle = 4;
  const double half_angle = 0.6;
  const double near = 0.5;
  const double far = 3;
  const FlattenInput input = test::cone_patch(n, n, near, far, half_angle, angle);
  const double sector = 2 * std::asin(std::sin(half_angle) * std::sin(angle / n / 2));  // the mesh is a pyramid
  const auto unroll = [&](int i, int j) { return std::polar(far + (near - far) * j / n, sector * i - kPi / 2); };
  for (double heading = 0.05; heading < 2 * kPi; heading += 0.51) {
    const UnrolledTrace trace = trace_unrolled(input, n, 25, 31, heading, unroll);
    EXPECT_GT(trace.num_points, 20u) << heading;
    EXPECT_LT(trace.largest_miss, 1e-10) << heading;
  }
}

/// Largest distance of a trace on the sphere from the great circle it starts along.
double miss_of_great_circle(int n) {
  const Charts charts = test::charts_of(test::quarter_sphere(n));
  Chart chart = charts.charts[0];
  chart.wire_parts.clear();
  const HalfEdgeMesh& mesh = chart.mesh;
  const VertexHandle start(n / 2 + (n + 1) * n);  // where meridian and equator cross
  const HalfedgeHandle reference = mesh.find_halfedge(start, VertexHandle(start.idx() + 1));
  const double heading = 0.6;
  const auto path = trace_straightest(mesh, WireMask(chart), reference, heading);
  if (!path) return 1;
  const HalfEdgeMesh::Point east(-std::sqrt(0.5), std::sqrt(0.5), 0);
  const HalfEdgeMesh::Point direction = east * std::cos(heading) + HalfEdgeMesh::Point(0, 0, std::sin(heading));
  const HalfEdgeMesh::Point normal = mesh.point(start) % direction;
  double largest = 0;
  for (const PathPoint& point : *path) largest = std::max(largest, std::abs(position(mesh, point) | normal));
  return largest;
}

TEST(StraightestGeodesic, TendsToAGreatCircleOnTheSphere) {
  EXPECT_LT(miss_of_great_circle(16), 0.02);
  EXPECT_LT(miss_of_great_circle(64), 0.005);
  EXPECT_LT(miss_of_great_circle(256), 0.00125);
}

/// A pyramid of two rings of n vertices and an apex, the last vertex.
FlattenInput pyramid(int n) {
  FlattenInput input = test::make_tube(n, 1, [&](double s, double t) {
    return Eigen::Vector3d((2 - t) * std::cos(2 * kPi * s), (2 - t) * std::sin(2 * kPi * s), t);
  });
  input.vertices.conservativeResize(2 * n + 1, 3);
  input.vertices.row(2 * n) << 0, 0, 2;
  input.faces.conservativeResize(3 * n, 3);
  for (int i = 0; i < n; ++i) input.faces.row(2 * n + i) << n + i, n + (i + 1) % n, 2 * n;
  return input;
}

TEST(StraightestGeodesic, LeavesAnApexWithEqualAnglesLeftAndRight) {
  for (const int n : {5, 6, 7, 8}) {
    const Charts charts = test::charts_of(pyramid(n));
    const HalfEdgeMesh& mesh = charts.charts[0].mesh;
    const HalfedgeHandle to_apex = mesh.find_halfedge(VertexHandle(n), VertexHandle(2 * n));
    const auto path = trace_straightest(mesh, WireMask(charts.charts[0]), to_apex, 0);
    ASSERT_TRUE(path);
    ASSERT_EQ(path->size(), n % 2 == 0 ? 4u : 5u) << "along an edge, or through the middle of a side";
    EXPECT_EQ((*path)[1].vertex, VertexHandle(2 * n));
    const auto beyond = position(mesh, (*path)[2]);
    EXPECT_LT(beyond[0], 0);
    EXPECT_NEAR(beyond[1], 0, 1e-14) << "the mirror plane of the pyramid";
  }
}

TEST(StraightestGeodesic, EndsAtTheFirstWire) {
  const int n = 8;
  FlattenInput input = test::flat_rectangle(n, n, 1, 1);
  test::add_wire(input, test::grid_column(n, n, 6));
  const Charts charts = test::charts_of(input);
  const HalfEdgeMesh& mesh = charts.charts[0].mesh;
  const VertexHandle start(3 + (n + 1) * 4);
  const HalfedgeHandle reference = mesh.find_halfedge(start, VertexHandle(start.idx() + 1));
  const auto path = trace_straightest(mesh, WireMask(charts.charts[0]), reference, 0.2);
  ASSERT_TRUE(path);
  EXPECT_NEAR(position(mesh, path->back())[0], 6.0 / n, 1e-14);
  EXPECT_NEAR(position(mesh, path->back())[1], 4.0 / n + 3.0 / n * std::tan(0.2), 1e-14);
}

TEST(StraightestGeodesic, IsGivenUpWhenItComesBack) {
  const int nx = 12;
  const Charts charts = test::charts_of(test::cylinder_tube(nx, 8, 1, 2));
  const HalfEdgeMesh& mesh = charts.charts[0].mesh;
  const VertexHandle start(nx * 4);
  const HalfedgeHandle around = mesh.find_halfedge(start, VertexHandle(nx * 4 + 1));
  const WireMask wires(charts.charts[0]);
  EXPECT_FALSE(trace_straightest(mesh, wires, around, 0)) << "a ring of edges";
  EXPECT_FALSE(trace_straightest(mesh, wires, around, 1e-4)) << "a flat spiral";
  EXPECT_TRUE(trace_straightest(mesh, wires, around, 1)) << "a steep one";
}

TEST(StraightestGeodesic, DoesNotDependOnScale) {
  const int n = 10;
  std::vector<std::size_t> num_points;
  std::vector<double> length;
  for (const double scale : {1.0, 1e-6, 1e6}) {
    FlattenInput input = test::saddle(n, 0.4);
    input.vertices *= scale;
    const Charts charts = test::charts_of(input);
    const HalfEdgeMesh& mesh = charts.charts[0].mesh;
    const VertexHandle start(5 + (n + 1) * 5);
    const HalfedgeHandle reference = mesh.find_halfedge(start, VertexHandle(start.idx() + 1));
    const auto path = trace_straightest(mesh, WireMask(charts.charts[0]), reference, 0.3);
    ASSERT_TRUE(path);
    num_points.push_back(path->size());
    length.push_back(path_length(mesh, *path) / scale);
  }
  EXPECT_EQ(num_points[1], num_points[0]);
  EXPECT_EQ(num_points[2], num_points[0]);
  EXPECT_NEAR(length[1], length[0], 1e-12);
  EXPECT_NEAR(length[2], length[0], 1e-12);
}

}  // namespace
}  // namespace wirewarp::test_straightest_geodesic
