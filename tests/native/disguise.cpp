// SPDX-License-Identifier: GPL-3.0-or-later
#include "disguise.h"

#include <Eigen/Geometry>
#include <stdexcept>

#include "test_meshes.h"

namespace wirewarp::test {
namespace {

int place_of(const FlattenInput& input, int v) {
  const int count = static_cast<int>(input.vertices.rows());
  if (count % 7 == 0) throw std::logic_error("the number of vertices must not be a multiple of 7");
  return (v * 7 + 3) % count;
}

}  // namespace

FlattenInput disguised(const FlattenInput& input) {
  FlattenInput result = input;
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  for (int v = 0; v < input.vertices.rows(); ++v) {
    const Eigen::Vector3d p = input.vertices.row(v).transpose();
    result.vertices.row(place_of(input, v)) = (turn * Eigen::Vector3d(-p.x(), p.y(), p.z())).transpose();
  }
  const auto num_faces = input.faces.rows();
  for (Eigen::Index f = 0; f < num_faces; ++f) {
    const auto face = input.faces.row(num_faces - 1 - f);
    result.faces.row(f) << place_of(input, face[1]), place_of(input, face[0]), place_of(input, face[2]);
  }
  for (int& v : result.seams.reshaped()) v = place_of(input, v);
  for (Wire& wire : result.wires) {
    for (int& v : wire.vertices) v = place_of(input, v);
  }
  return result;
}

std::vector<VertexPair> disguised(const FlattenInput& input, const std::vector<VertexPair>& edges) {
  std::vector<VertexPair> result;
  for (const VertexPair& edge : edges) result.push_back({place_of(input, edge[0]), place_of(input, edge[1])});
  return result;
}

FlattenInput with_seams(FlattenInput input, const std::vector<VertexPair>& edges) {
  for (const VertexPair& edge : edges) add_seam(input, {edge[0], edge[1]});
  return input;
}

}  // namespace wirewarp::test
