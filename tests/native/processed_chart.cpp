// SPDX-License-Identifier: GPL-3.0-or-later
#include "processed_chart.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "surface/mesh/geometry.h"
#include "surface/network/wire_network.h"
#include "test_meshes.h"
#include "warp/inner/inner_problem.h"
#include "warp/inner/interior_placement.h"
#include "warp/inner/wire_layout.h"
#include "warp/topology/process_topology.h"

namespace wirewarp::test {
namespace {

using Point = HalfEdgeMesh::Point;

std::array<Point, 3> corners(const HalfEdgeMesh& mesh, FaceHandle f) {
  const HalfedgeHandle h = mesh.halfedge_handle(f);
  return {mesh.point(mesh.from_vertex_handle(h)), mesh.point(mesh.to_vertex_handle(h)),
          mesh.point(mesh.to_vertex_handle(mesh.next_halfedge_handle(h)))};
}

Point area_vector(const std::array<Point, 3>& p) { return ((p[1] - p[0]) % (p[2] - p[0])) / 2; }

/// Expects that the triangles that replace an input face lie in this face, fill it and have its orientation.
void expect_same_surface(const Chart& chart, const Chart& refined) {
  ASSERT_EQ(refined.source_face.size(), refined.mesh.n_faces());
  std::vector<int> chart_face(1 + *std::max_element(chart.source_face.begin(), chart.source_face.end()));
  for (const FaceHandle f : chart.mesh.faces()) chart_face[chart.source_face[f.idx()]] = f.idx();
  std::vector<double> covered(chart.mesh.n_faces(), 0);
  for (const FaceHandle f : refined.mesh.faces()) {
    const FaceHandle input(chart_face[refined.source_face[f.idx()]]);
    const auto outer = corners(chart.mesh, input);
    const Point normal = area_vector(outer).normalized();
    const double outer_area = area_vector(outer).norm();
    const auto inner = corners(refined.mesh, f);
    EXPECT_GT(area_vector(inner) | normal, 1e-9 * outer_area) << "a flipped or flat triangle";
    covered[input.idx()] += area_vector(inner) | normal;
    for (const Point& p : inner) {
      EXPECT_LT(std::abs((p - outer[0]) | normal), 1e-12 * std::sqrt(outer_area)) << "off the surface";
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_GT(area_vector({outer[k], outer[(k + 1) % 3], p}) | normal, -1e-12 * outer_area) << "outside its face";
      }
    }
  }
  for (const FaceHandle f : chart.mesh.faces()) {
    EXPECT_NEAR(covered[f.idx()], area_vector(corners(chart.mesh, f)).norm(), 1e-12 * covered[f.idx()]);
  }
}

void expect_same_chain(const HalfEdgeMesh& before, const HalfEdgeMesh& after, const HalfEdgeChain& chain) {
  for (const HalfedgeHandle h : chain) {
    EXPECT_EQ(before.from_vertex_handle(h), after.from_vertex_handle(h));
    EXPECT_EQ(before.to_vertex_handle(h), after.to_vertex_handle(h));
  }
}

void expect_own_parts_kept(const Chart& chart, const Chart& refined) {
  ASSERT_GE(refined.mesh.n_vertices(), chart.mesh.n_vertices());
  for (const VertexHandle v : refined.mesh.vertices()) {
    const bool is_own = static_cast<std::size_t>(v.idx()) < chart.mesh.n_vertices();
    EXPECT_EQ(refined.source_vertex[v.idx()], is_own ? chart.source_vertex[v.idx()] : -1);
    if (is_own) {
      EXPECT_EQ(refined.mesh.point(v), chart.mesh.point(v));
    }
  }
  ASSERT_EQ(refined.boundary_loops, chart.boundary_loops);
  for (const HalfEdgeChain& loop : chart.boundary_loops) expect_same_chain(chart.mesh, refined.mesh, loop);
  for (std::size_t i = 0; i < chart.wire_parts.size(); ++i) {
    ASSERT_EQ(refined.wire_parts[i].half_edges, chart.wire_parts[i].half_edges);
    expect_same_chain(chart.mesh, refined.mesh, chart.wire_parts[i].half_edges);
  }
}

void expect_sound_helpers(const Chart& chart, const Chart& refined) {
  std::set<int> edges;  // of wires and outlines
  for (const HalfEdgeChain& loop : refined.boundary_loops) {
    for (const HalfedgeHandle h : loop) edges.insert(refined.mesh.edge_handle(h).idx());
  }
  for (std::size_t i = 0; i < refined.wire_parts.size(); ++i) {
    const WirePart& part = refined.wire_parts[i];
    if (part.kind == WireKind::boundary) continue;
    for (std::size_t k = 0; k < part.half_edges.size(); ++k) {
      const HalfedgeHandle h = part.half_edges[k];
      EXPECT_TRUE(edges.insert(refined.mesh.edge_handle(h).idx()).second) << "an edge on two wires";
      if (k > 0) {
        EXPECT_EQ(refined.mesh.to_vertex_handle(part.half_edges[k - 1]), refined.mesh.from_vertex_handle(h));
      }
    }
    if (i < chart.wire_parts.size()) continue;
    EXPECT_EQ(part.wire_index, -1);
    EXPECT_EQ(part.part, static_cast<int>(i - chart.wire_parts.size()));
    EXPECT_EQ(part.kind, WireKind::super_elastic);
    EXPECT_EQ(part.tolerance, std::numeric_limits<double>::infinity());
    EXPECT_FALSE(part.half_edges.empty());
  }
}

}  // namespace

Processed process(const FlattenInput& input) {
  Processed result{test::charts_of(input).charts[0], {}};
  std::optional<Chart> refined = process_topology(result.chart);
  EXPECT_TRUE(refined) << "the chart needs processing";
  if (!refined) return result;
  result.refined = std::move(*refined);
  expect_same_surface(result.chart, result.refined);
  expect_own_parts_kept(result.chart, result.refined);
  expect_sound_helpers(result.chart, result.refined);
  EXPECT_FALSE(process_topology(result.refined)) << "processing a second time changes nothing";
  return result;
}

double stretch_of_flattening(const Chart& chart) {
  const WireNetwork network = build_wire_network(chart);
  Eigen::VectorXd lengths(network.edges.size());
  for (Eigen::Index e = 0; e < lengths.size(); ++e) lengths[e] = network.edges[e].length;
  InnerProblem inner(network, NodeWeight::length);
  const InnerSolution solution = inner.solve(lengths, Inner::minimum);
  EXPECT_TRUE(solution.is_feasible);
  Positions2 uv(static_cast<int>(chart.mesh.n_vertices()), 2);
  WireLayout(chart, network).place(solution.headings, lengths, uv);
  InteriorPlacement(chart, network).place(uv);
  double largest = 0;
  for (const EdgeHandle e : chart.mesh.edges()) {
    const HalfedgeHandle h = chart.mesh.halfedge_handle(e, 0);
    const double length = edge_length(chart.mesh, h);
    const double flat =
        (uv.row(chart.mesh.to_vertex_handle(h).idx()) - uv.row(chart.mesh.from_vertex_handle(h).idx())).norm();
    largest = std::max(largest, std::abs(flat - length) / length);
  }
  return largest;
}

}  // namespace wirewarp::test
