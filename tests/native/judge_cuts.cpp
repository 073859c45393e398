// SPDX-License-Identifier: GPL-3.0-or-later
#include "judge_cuts.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "disguise.h"
#include "surface/mesh/widespread.h"

namespace wirewarp::test {

double most_strain(const FlattenInput& input, const FlattenResult& result) {
  double most = 0;
  for (const Piece& piece : result.pieces) {
    std::vector<double> areas;
    for (const int f : piece.source_face) {
      const Eigen::Vector3d a = input.vertices.row(input.faces(f, 0)), b = input.vertices.row(input.faces(f, 1)),
                            c = input.vertices.row(input.faces(f, 2));
      areas.push_back((b - a).cross(c - a).norm() / 2);
    }
    most = std::max(most, widespread(areas, piece.metrics.face_aspect_ratio.array() - 1));
  }
  return most;
}

double energy_of(const FlattenResult& result, bool has_cloth) {
  double energy = 0, area = 0;
  for (const Piece& piece : result.pieces) {
    energy += (has_cloth ? piece.metrics.cloth_energy : piece.metrics.arap_energy) * piece.metrics.area_3d;
    area += piece.metrics.area_3d;
  }
  return energy / area;
}

std::set<VertexPair> undirected(const std::vector<VertexPair>& edges) {
  std::set<VertexPair> pairs;
  for (const VertexPair& edge : edges) pairs.insert({std::min(edge[0], edge[1]), std::max(edge[0], edge[1])});
  return pairs;
}

std::set<VertexPair> undirected(const VertexPairs& edges) {
  std::vector<VertexPair> list;
  for (const auto& row : edges.rowwise()) list.push_back({row[0], row[1]});
  return undirected(list);
}

double length_of_seams(const FlattenInput& input) {
  double length = 0;
  for (const VertexPair& edge : undirected(input.seams)) {
    length += (input.vertices.row(edge[0]) - input.vertices.row(edge[1])).norm();
  }
  return length;
}

FlattenInput with_paths(FlattenInput input, const std::vector<SurfacePath>& paths) {
  const CutMesh cut = cut_mesh(input.vertices, input.faces, paths);
  input.vertices = cut.vertices;
  input.faces = cut.faces;
  return with_seams(std::move(input), cut.edges);
}

Eigen::RowVector3d point_of(const FlattenInput& input, const SurfacePath& path, std::size_t i) {
  Eigen::RowVector3d point = Eigen::RowVector3d::Zero();
  for (int k = 0; k < 3; ++k) point += path.coordinates(i, k) * input.vertices.row(input.faces(path.faces[i], k));
  return point;
}

void expect_figures(const FlattenInput& cut, const CutFigures& claimed) {
  const FlattenResult result = flatten(cut);
  for (const Piece& piece : result.pieces) ASSERT_FALSE(piece.error) << piece.error->what();
  const double energy = energy_of(result), length = length_of_seams(cut);
  EXPECT_NEAR(claimed.energy, energy, 1e-6 * energy + 1e-15);
  EXPECT_NEAR(claimed.strain, most_strain(cut, result), 1e-6);
  EXPECT_NEAR(claimed.length, length, 1e-9 * length);
  EXPECT_EQ(claimed.num_pieces, static_cast<int>(result.pieces.size()));
}

void expect_figures(const FlattenInput& input, const DartProposal& claimed) {
  expect_figures(claimed.paths.empty() ? with_seams(input, claimed.edges) : with_paths(input, claimed.paths),
                 {claimed.energy, claimed.strain, claimed.length, claimed.num_pieces});
}

}  // namespace wirewarp::test
