// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <queue>
#include <set>

#include "random_input.h"

namespace wirewarp::test {
namespace {

/// Returns the vertices of the part of the mesh that contains vertex `start`.
std::set<int> part_around(const FlattenInput& input, int start) {
  std::vector<std::vector<int>> neighbors(input.vertices.rows());
  for (const auto& face : input.faces.rowwise()) {
    for (int k = 0; k < 3; ++k) neighbors[face[k]].push_back(face[(k + 1) % 3]);
  }
  // One direction of each edge is enough, because a walk around a face reaches all its corners.
  std::set<int> part{start};
  std::queue<int> front;
  for (front.push(start); !front.empty(); front.pop()) {
    for (const int next : neighbors[front.front()]) {
      if (part.insert(next).second) front.push(next);
    }
  }
  return part;
}

int random_corner(RandomStream& random, const FlattenInput& input) {
  return input.faces(random.below(static_cast<int>(input.faces.rows())), random.below(3));
}

int neighbor_of(const FlattenInput& input, int vertex) {
  for (const auto& face : input.faces.rowwise()) {
    for (int k = 0; k < 3; ++k) {
      if (face[k] == vertex) return face[(k + 1) % 3];
    }
  }
  return -1;
}

bool has_wire(const FlattenInput& input, int a, int b) {
  return std::any_of(input.wires.begin(), input.wires.end(), [&](const Wire& wire) {
    const std::vector<Edge> edges = edges_of(wire);
    return std::find(edges.begin(), edges.end(), edge_of(a, b)) != edges.end();
  });
}

}  // namespace

bool let_parts_touch(RandomStream& random, FlattenInput& input) {
  const int kept = random_corner(random, input);
  const int merged = random_corner(random, input);
  const double tolerance = random.pick(std::vector<double>{0, 0.05, 0.2});
  const std::set<int> part = part_around(input, merged);
  if (part.count(kept)) return false;
  const Eigen::RowVector3d way = input.vertices.row(kept) - input.vertices.row(merged);
  for (const int v : part) input.vertices.row(v) += way;

  const int before = neighbor_of(input, kept), beyond = neighbor_of(input, merged);
  const auto rename = [&](int v) { return v == merged ? kept : v; };
  input.faces = input.faces.unaryExpr(rename).eval();
  input.seams = input.seams.unaryExpr(rename).eval();
  for (Wire& wire : input.wires) {
    std::transform(wire.vertices.begin(), wire.vertices.end(), wire.vertices.begin(), rename);
  }
  if (!has_wire(input, before, kept) && !has_wire(input, kept, beyond)) {
    input.wires.push_back({{before, kept, beyond}, tolerance, "through the point of touch"});
  }
  return true;
}

}  // namespace wirewarp::test
