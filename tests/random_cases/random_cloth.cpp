// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <vector>

#include "random_input.h"

namespace wirewarp::test {
namespace {

std::set<Edge> edges_of_wires(const FlattenInput& input) {
  std::set<Edge> edges;
  for (const Wire& wire : input.wires) {
    for (const Edge& edge : edges_of(wire)) edges.insert(edge);
  }
  return edges;
}

/// Returns a chain of edges that begins with the first edge of the set. Removes the edges of the chain from the set.
std::vector<int> take_chain(std::set<Edge>& edges) {
  std::vector<int> chain{(*edges.begin())[0], (*edges.begin())[1]};
  edges.erase(edges.begin());
  while (true) {
    const auto next = std::find_if(edges.begin(), edges.end(),
                                   [&](const Edge& e) { return e[0] == chain.back() || e[1] == chain.back(); });
    if (next == edges.end()) return chain;
    chain.push_back((*next)[0] == chain.back() ? (*next)[1] : (*next)[0]);
    edges.erase(next);
  }
}

void add_wires_along_seams(RandomStream& random, FlattenInput& input) {
  const std::set<Edge> taken = edges_of_wires(input);
  std::set<Edge> free;
  for (const auto& seam : input.seams.rowwise()) {
    const Edge edge = edge_of(seam[0], seam[1]);
    if (taken.count(edge) == 0) free.insert(edge);
  }
  const std::vector<double> tolerances{0, 0.01, 0.03, 0.1, std::numeric_limits<double>::infinity()};
  while (!free.empty()) {
    const std::vector<int> chain = take_chain(free);
    if (!random.chance(0.7)) continue;
    input.wires.push_back({chain, random.pick(tolerances), "seam " + std::to_string(input.wires.size())});
  }
}

void add_eases_of_wires(RandomStream& random, FlattenInput& input) {
  for (Wire& wire : input.wires) {
    if (random.chance(0.2)) wire.ease = random.between(-0.1, 0.1);
  }
}

/// Adds one ease, which applies to random sides of seams and borders.
void add_eases_of_sides(RandomStream& random, FlattenInput& input) {
  std::map<Edge, int> num_faces;
  std::map<VertexPair, int> num_sides;  // number of faces on the left of each directed edge
  for (const auto& face : input.faces.rowwise()) {
    for (int k = 0; k < 3; ++k) {
      ++num_faces[edge_of(face[k], face[(k + 1) % 3])];
      ++num_sides[{face[k], face[(k + 1) % 3]}];
    }
  }
  std::set<Edge> seams;
  for (const auto& seam : input.seams.rowwise()) seams.insert(edge_of(seam[0], seam[1]));
  std::vector<VertexPair> sides;
  for (const auto& face : input.faces.rowwise()) {
    for (int k = 0; k < 3; ++k) {
      const int a = face[k], b = face[(k + 1) % 3];
      const bool is_outline = seams.count(edge_of(a, b)) > 0 || num_faces[edge_of(a, b)] == 1;
      // Two sides of a non-manifold seam may have the same direction, and an ease cannot distinguish them.
      if (is_outline && random.chance(0.2) && num_sides[{a, b}] == 1) sides.push_back({a, b});
    }
  }
  if (sides.empty()) return;
  Ease ease;
  ease.half_edges.resize(sides.size(), 2);
  for (std::size_t i = 0; i < sides.size(); ++i) ease.half_edges.row(i) << sides[i][0], sides[i][1];
  ease.ratio = random.between(-0.05, 0.1);
  input.eases.push_back(ease);
}

Cloth random_cloth(RandomStream& random) {
  Cloth cloth = random.chance(0.3) ? random.pick(cloth_presets()).cloth : Cloth{};
  if (random.chance(0.5)) cloth.shear = random.across_scales(0.02, 1);
  if (random.chance(0.5)) cloth.warp = random.across_scales(0.1, 10);
  if (random.chance(0.3)) cloth.squeeze = random.across_scales(0.2, 5);
  for (double& stretch : cloth.stretch) stretch = random.between(-0.1, 0.3);
  if (random.chance(0.2)) cloth.stretch[random.below(2)] = 0;
  if (random.chance(0.1)) cloth.stretch[1] = cloth.stretch[0];
  return cloth;
}

}  // namespace

void add_random_stretch(RandomStream& random, FlattenInput& input, Options& options, std::string& description) {
  options.cloth = random_cloth(random);
  if (random.chance(0.1)) options.orientation = Orientation::best;
  if (random.chance(0.3)) options.grain_angle = random.between(-3, 3);
  description += " stretched";
  if (random.chance(0.5)) {
    add_wires_along_seams(random, input);
    description += " elastic-seams";
  }
  if (random.chance(0.4)) {
    add_eases_of_wires(random, input);
    if (random.chance(0.5)) add_eases_of_sides(random, input);
    description += " eased";
  }
}

}  // namespace wirewarp::test
