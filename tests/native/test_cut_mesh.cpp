// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of meshes that are cut along lines.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "error_of.h"
#include "judge_cuts.h"
#include "surface/mesh/edge_table.h"
#include "test_meshes.h"
#include "wirewarp/cut_mesh.h"

namespace wirewarp::test_cut_mesh {
namespace {

Eigen::Vector3d corner(const Positions3& vertices, const Triangles& faces, Eigen::Index f, int k) {
  return vertices.row(faces(f, k)).transpose();
}

Eigen::Vector3d doubled_area_of(const Positions3& vertices, const Triangles& faces, Eigen::Index f) {
  const Eigen::Vector3d a = corner(vertices, faces, f, 0);
  return (corner(vertices, faces, f, 1) - a).cross(corner(vertices, faces, f, 2) - a);
}

SurfacePath path_of(const std::vector<int>& faces, const std::vector<std::array<double, 3>>& coordinates) {
  SurfacePath path{faces, Positions3(coordinates.size(), 3)};
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    for (int k = 0; k < 3; ++k) path.coordinates(i, k) = coordinates[i][k];
  }
  return path;
}

/// Returns a line that wanders from face to face across their edges, with points inside some faces.
SurfacePath scribble(const FlattenInput& mesh, std::mt19937& random, int steps) {
  const EdgeTable edges(mesh.faces, static_cast<int>(mesh.vertices.rows()));
  std::uniform_real_distribution<double> share(0, 1);
  std::uniform_int_distribution<int> side(0, 2), face(0, static_cast<int>(mesh.faces.rows()) - 1);
  std::vector<int> faces;
  std::vector<std::array<double, 3>> points;
  for (int f = face(random); steps > 0; --steps) {
    if (share(random) < 0.4) {
      const double a = share(random), b = share(random) * (1 - a);
      faces.push_back(f);
      points.push_back({a, b, 1 - a - b});
    }
    const int exit = side(random);
    const double t = share(random);
    std::array<double, 3> at{};
    at[exit] = 1 - t;
    at[(exit + 1) % 3] = t;
    faces.push_back(f);
    points.push_back(at);
    const int edge = edges.edge_of_side(3 * f + exit);
    for (int j = 0; j < edges.num_sides(edge); ++j) {
      if (edges.side(edge, j) / 3 == f) continue;
      f = edges.side(edge, j) / 3;
      break;
    }
  }
  return path_of(faces, points);
}

/// Returns the line where a plane cuts the mesh, from outline to outline. distance: signed distance of each vertex from
/// the plane.
SurfacePath line_in_plane(const FlattenInput& mesh, const Eigen::VectorXd& distance) {
  const EdgeTable edges(mesh.faces, static_cast<int>(mesh.vertices.rows()));
  const auto share = [&](int side) {
    const double from = distance[edges.from(side)], to = distance[edges.to(side)];
    return from * to < 0 ? from / (from - to) : -1;
  };
  std::vector<int> faces;
  std::vector<std::array<double, 3>> points;
  const auto pass = [&](int side) {
    std::array<double, 3> at{};
    at[side % 3] = 1 - share(side);
    at[(side + 1) % 3] = share(side);
    faces.push_back(side / 3);
    points.push_back(at);
  };
  int entry = 0;
  while (share(entry) < 0 || edges.num_sides(edges.edge_of_side(entry)) != 1) ++entry;
  while (true) {
    if (points.empty()) pass(entry);
    int exit = entry - entry % 3 + (entry + 1) % 3;
    if (share(exit) < 0) exit = entry - entry % 3 + (entry + 2) % 3;
    pass(exit);
    const int edge = edges.edge_of_side(exit);
    if (edges.num_sides(edge) == 1) return path_of(faces, points);
    entry = edges.side(edge, 0) == exit ? edges.side(edge, 1) : edges.side(edge, 0);
  }
}

SurfacePath line_in_random_plane(const FlattenInput& mesh, std::mt19937& random) {
  std::normal_distribution<double> number;
  const Eigen::Vector3d normal(number(random), number(random), number(random));
  const Eigen::RowVector3d center = mesh.vertices.colwise().mean();
  SurfacePath line = line_in_plane(mesh, (mesh.vertices.rowwise() - center) * normal);
  const bool cuts_only_a_corner = line.faces.size() <= 4;
  return cuts_only_a_corner ? line_in_random_plane(mesh, random) : line;
}

/// Returns the smallest ratio of a face's height to the height of the input face that contains it. Heights are measured
/// from the longest side.
double least_height(const FlattenInput& mesh, const CutMesh& cut) {
  const auto height = [](const Positions3& vertices, const Triangles& faces, Eigen::Index f) {
    double longest = 0;
    for (int k = 0; k < 3; ++k) {
      longest = std::max(longest, (corner(vertices, faces, f, k) - corner(vertices, faces, f, (k + 1) % 3)).norm());
    }
    return doubled_area_of(vertices, faces, f).norm() / longest;
  };
  double least = 1;
  for (Eigen::Index f = 0; f < cut.faces.rows(); ++f) {
    const double before = height(mesh.vertices, mesh.faces, cut.sources.faces[f]);
    least = std::min(least, height(cut.vertices, cut.faces, f) / before);
  }
  return least;
}

void expect_same_surface(const FlattenInput& mesh, const CutMesh& cut) {
  ASSERT_EQ(cut.vertices.topRows(mesh.vertices.rows()), mesh.vertices);
  ASSERT_EQ(cut.sources.faces.size(), static_cast<std::size_t>(cut.faces.rows()));
  Eigen::VectorXd area = Eigen::VectorXd::Zero(mesh.faces.rows());
  for (Eigen::Index f = 0; f < cut.faces.rows(); ++f) {
    const int source = cut.sources.faces[f];
    const Eigen::Vector3d whole = doubled_area_of(mesh.vertices, mesh.faces, source);
    const Eigen::Vector3d part = doubled_area_of(cut.vertices, cut.faces, f);
    EXPECT_GT(part.dot(whole), 0.999999 * part.norm() * whole.norm()) << "face " << f << " is flipped";
    area[source] += part.norm() / whole.norm();
    for (int k = 0; k < 3; ++k) {
      Eigen::Vector3d place = Eigen::Vector3d::Zero();
      for (int j = 0; j < 3; ++j) {
        const double share = cut.sources.corner_weights(f, 3 * k + j);
        EXPECT_GE(share, 0);
        place += share * corner(mesh.vertices, mesh.faces, source, j);
      }
      EXPECT_LT((place - corner(cut.vertices, cut.faces, f, k)).norm(), 1e-14);
    }
  }
  EXPECT_LT((area.array() - 1).abs().maxCoeff(), 1e-12) << "parts of a face do not fill it";
  for (Eigen::Index v = 0; v < cut.vertices.rows(); ++v) {
    Eigen::RowVector3d place = Eigen::RowVector3d::Zero();
    for (int k = 0; k < 3; ++k) {
      place += cut.sources.vertex_weights(v, k) * mesh.vertices.row(cut.sources.vertices(v, k));
    }
    EXPECT_LT((place - cut.vertices.row(v)).norm(), 1e-14);
  }
  const int before = static_cast<int>(mesh.vertices.rows()), after = static_cast<int>(cut.vertices.rows());
  const EdgeTable edges(mesh.faces, before), new_edges(cut.faces, after);
  const auto euler = [](int vertices, const EdgeTable& table, const Triangles& faces) {
    return vertices - table.num_edges() + static_cast<int>(faces.rows());
  };
  EXPECT_EQ(euler(before, edges, mesh.faces), euler(after, new_edges, cut.faces));
  for (int e = 0; e < new_edges.num_edges(); ++e) {
    ASSERT_LE(new_edges.num_sides(e), 2);
    if (new_edges.num_sides(e) == 2) {
      EXPECT_NE(new_edges.from(new_edges.side(e, 0)), new_edges.from(new_edges.side(e, 1)));
    }
  }
  for (const VertexPair& edge : cut.edges) EXPECT_GE(new_edges.find(edge[0], edge[1]), 0);
  for (const std::vector<int>& line : cut.sources.divided_edges) {
    EXPECT_GE(edges.find(line.front(), line.back()), 0);
    EXPECT_GE(line.size(), 3U);
    for (std::size_t i = 1; i < line.size(); ++i) EXPECT_GE(new_edges.find(line[i - 1], line[i]), 0);
  }
}

TEST(CutMesh, ALineAcrossASquareIsStraightAndKeepsItsLength) {
  // The line goes from (0, 1/4) to (1, 1/2). It crosses the diagonal of the square at (x, x). With x = 1/4 + x/4, x is
  // 1/3.
  const FlattenInput square = test::flat_rectangle(1, 1, 1, 1);  // faces 0-1-3 and 0-3-2
  const SurfacePath path = path_of({1, 1, 0}, {{0.75, 0, 0.25}, {2.0 / 3, 1.0 / 3, 0}, {0, 0.5, 0.5}});
  const CutMesh cut = cut_mesh(square.vertices, square.faces, {path});
  expect_same_surface(square, cut);
  ASSERT_EQ(cut.edges.size(), 2U);
  double length = 0;
  for (const VertexPair& edge : cut.edges) length += (cut.vertices.row(edge[0]) - cut.vertices.row(edge[1])).norm();
  EXPECT_NEAR(length, std::hypot(1, 0.25), 1e-15);
  EXPECT_EQ(cut.faces.rows(), 6);  // each of two faces becomes a triangle and a quadrilateral of two triangles
  const std::vector<std::vector<int>> divided{{0, 5, 3}, {0, 4, 2}, {1, 6, 3}};
  EXPECT_EQ(std::set(cut.sources.divided_edges.begin(), cut.sources.divided_edges.end()),
            std::set(divided.begin(), divided.end()));
}

TEST(CutMesh, CrossingLinesShareAVertexWhereTheyCross) {
  const FlattenInput triangle = test::mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  const SurfacePath first = path_of({0, 0}, {{0.5, 0.5, 0}, {0, 0, 1}}),
                    second = path_of({0, 0}, {{0.5, 0, 0.5}, {0, 1, 0}});
  const CutMesh cut = cut_mesh(triangle.vertices, triangle.faces, {first, second});
  expect_same_surface(triangle, cut);
  // The medians meet in the centroid.
  ASSERT_EQ(cut.vertices.rows(), 6);
  EXPECT_LT((cut.vertices.row(5) - Eigen::RowVector3d(1.0 / 3, 1.0 / 3, 0)).norm(), 1e-15);
  EXPECT_EQ(cut.edges, (std::vector<VertexPair>{{3, 5}, {5, 2}, {4, 5}, {5, 1}}));
  EXPECT_EQ(cut.sources.edge_paths, (std::vector<int>{0, 0, 1, 1}));
}

TEST(CutMesh, ALineAlongEdgesChangesNothing) {
  const FlattenInput sphere = test::quarter_sphere(6);
  const EdgeTable edges(sphere.faces, static_cast<int>(sphere.vertices.rows()));
  const std::vector<int> column = test::grid_column(6, 12, 2);
  SurfacePath path{{}, Positions3::Zero(column.size(), 3)};
  for (std::size_t i = 0; i < column.size(); ++i) {
    for (int side = 0; side < 3 * static_cast<int>(sphere.faces.rows()); ++side) {
      if (edges.from(side) != column[i]) continue;
      path.faces.push_back(side / 3);
      path.coordinates(i, side % 3) = 1;
      break;
    }
  }
  const CutMesh cut = cut_mesh(sphere.vertices, sphere.faces, {path, path});
  EXPECT_EQ(cut.vertices, sphere.vertices);
  EXPECT_EQ(cut.faces, sphere.faces);
  ASSERT_EQ(cut.edges.size(), column.size() - 1) << "each edge once";
  for (std::size_t i = 1; i < column.size(); ++i) EXPECT_EQ(cut.edges[i - 1], (VertexPair{column[i - 1], column[i]}));
  EXPECT_TRUE(cut.sources.divided_edges.empty());
}

TEST(CutMesh, AStraightLineLeavesNoSlivers) {
  std::mt19937 random(5);
  for (int i = 0; i < 100; ++i) {
    const FlattenInput mesh = i % 2 == 0 ? test::quarter_sphere(6) : test::saddle(7, 0.8);
    const double snap = i % 4 < 2 ? 0.05 : 0.01;
    const SurfacePath path = line_in_random_plane(mesh, random);
    const CutMesh cut = cut_mesh(mesh.vertices, mesh.faces, {path}, snap);
    SCOPED_TRACE(i);
    expect_same_surface(mesh, cut);
    // The smallest height results if a line crosses two sides at the fractions snap and 1 - snap from their common
    // corner. The line then cuts off snap (1 - snap) of the area.
    EXPECT_GT(least_height(mesh, cut), snap * (1 - snap) * (1 - 1e-9));
  }
}

TEST(CutMesh, ScribblesKeepTheSurface) {
  std::mt19937 random(7);
  for (int i = 0; i < 100; ++i) {
    const FlattenInput mesh = i % 2 == 0 ? test::quarter_sphere(4) : test::sphere_of_gores(3, 3, 5);
    const double snap = i % 4 < 2 ? 0.05 : 0.01;
    std::vector<SurfacePath> paths;
    for (int p = 0; p < 1 + i % 5; ++p) paths.push_back(scribble(mesh, random, 5 + i % 40));
    const CutMesh cut = cut_mesh(mesh.vertices, mesh.faces, paths, snap);
    SCOPED_TRACE(i);
    expect_same_surface(mesh, cut);
    // The cut edges reach the first and the last point of each path.
    const double reach = 3 * snap * 0.7;  // 0.7: longest edge of the meshes
    for (const SurfacePath& path : paths) {
      for (const std::size_t at : {std::size_t{0}, path.faces.size() - 1}) {
        const Eigen::RowVector3d point = test::point_of(mesh, path, at);
        double nearest = 1;
        for (const VertexPair& edge : cut.edges) {
          for (const int v : edge) nearest = std::min(nearest, (cut.vertices.row(v) - point).norm());
        }
        EXPECT_LT(nearest, reach);
      }
    }
  }
}

std::string message_of(const std::vector<SurfacePath>& paths, double snap = 0.05) {
  const FlattenInput square = test::flat_rectangle(2, 1, 2, 1);
  return test::error_of([&] { cut_mesh(square.vertices, square.faces, paths, snap); }).what();
}

TEST(CutMesh, PathsThatAreNotLinesOnTheMeshAreRefused) {
  EXPECT_EQ(message_of({path_of({0}, {{1, 0, 0}})}), "The option path is too short: it must have two points or more.");
  EXPECT_EQ(message_of({path_of({0, 4}, {{1, 0, 0}, {1, 0, 0}})}),
            "The option paths[0] is a line in face 4: it must use the faces of the mesh, 0 to 3.");
  EXPECT_EQ(message_of({path_of({0, -1}, {{1, 0, 0}, {1, 0, 0}})}),
            "The option path is a line in face -1: it must use faces from 0 on.");
  EXPECT_EQ(message_of({path_of({0, 0}, {{1, 0, 0}, {0.5, 0.7, -0.2}})}),
            "The option path is at point 1 at 0.5, 0.7, -0.2: it must have coordinates of 0 or more with the sum 1.");
  EXPECT_EQ(message_of({path_of({0, 2}, {{0.3, 0.3, 0.4}, {0.3, 0.4, 0.3}})}),
            "The option paths[0] is a line whose points 0 and 1 have no common face: it must have a point on each edge "
            "that it crosses.");
  EXPECT_EQ(message_of({path_of({0, 0}, {{1, 0, 0}, {0.98, 0.01, 0.01}})}),
            "The option paths[0] is a line whose points all snap to one point: it must be longer.");
  EXPECT_EQ(message_of({}, 0.3), "The option snap is 0.3: it must be from 0.0001 to 0.25.");
  FlattenInput square = test::flat_rectangle(1, 1, 1, 1);
  square.faces.row(1) << 0, 3, 3;
  EXPECT_THROW(cut_mesh(square.vertices, square.faces, {}), FlattenError);
}

}  // namespace
}  // namespace wirewarp::test_cut_mesh
