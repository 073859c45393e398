// SPDX-License-Identifier: GPL-3.0-or-later
#include "check_input/check_input.h"

#include <cmath>
#include <set>

#include "disjoint_sets.h"
#include "errors/sentence.h"

namespace wirewarp {
namespace {

void check_vertices_in_range(const std::vector<int>& vertices, Eigen::Index num_vertices, const std::string& owner) {
  std::set<int> found;
  for (int v : vertices) {
    if (v < 0 || v >= num_vertices) found.insert(v);
  }
  if (found.empty()) return;
  const std::vector<int> bad(found.begin(), found.end());
  throw FlattenError(ErrorCode::vertex_out_of_range,
                     owner + " names " + name_elements("vertex", bad) + ", but the mesh has vertices 0 to " +
                         std::to_string(num_vertices - 1) + ": use indices of this mesh.",
                     {bad, {}, {}});
}

void check_seams(const FlattenInput& input, const EdgeTable& edges) {
  const std::vector<int> ends(input.seams.data(), input.seams.data() + input.seams.size());
  check_vertices_in_range(ends, input.vertices.rows(), "The list of seams");
  std::vector<VertexPair> bad;
  for (int i = 0; i < input.seams.rows(); ++i) {
    const VertexPair pair{input.seams(i, 0), input.seams(i, 1)};
    if (edges.find(pair[0], pair[1]) < 0) bad.push_back(pair);
  }
  if (bad.empty()) return;
  throw FlattenError(ErrorCode::seam_not_an_edge,
                     "Seam " + name_elements("edge", bad) + (bad.size() == 1 ? " is not an edge" : " are not edges") +
                         " of the mesh: mark seams on existing edges.",
                     {{}, bad, {}});
}

/// A sentence with the name would break off there.
void check_name(const Wire& wire) {
  if (wire.name.find('\0') == std::string::npos) return;
  throw FlattenError(ErrorCode::invalid_type, "The name of a wire has a NUL character: leave it out.");
}

/// owner: "The wire 2 has an ease".
void check_ratio(double ratio, const std::string& owner, const ErrorElements& named) {
  if (std::isfinite(ratio) && ratio > -1) return;
  throw FlattenError(ErrorCode::invalid_ease,
                     owner + " of " + shortest(ratio) + ": use a finite fraction above -1, such as 0.05 (5% longer).",
                     named);
}

/// vertices: of the mesh, to be named.
void check_chain_and_tolerance(const Wire& wire, const std::string& label, const std::vector<int>& vertices) {
  if (wire.vertices.size() < 2) {
    throw FlattenError(ErrorCode::wire_too_short,
                       "The " + label + " has fewer than two vertices: give it at least one edge.", {vertices, {}, {}});
  }
  if (!(wire.tolerance >= 0)) {
    throw FlattenError(ErrorCode::invalid_tolerance,
                       "The " + label + " has a tolerance of " + shortest(wire.tolerance) +
                           ": use 0 (rigid), a positive fraction such as 0.03 (3%), or infinity (free).",
                       {vertices, {}, {}});
  }
  check_ratio(wire.ease, "The " + label + " has an ease", {vertices, {}, {}});
}

void check_wire_on_mesh(const FlattenInput& input, const EdgeTable& edges, std::size_t w,
                        std::vector<int>& wire_of_edge) {
  const Wire& wire = input.wires[w];
  check_name(wire);
  const std::string label = name_wires(input.wires, {static_cast<int>(w)});
  check_vertices_in_range(wire.vertices, input.vertices.rows(), "The " + label);
  check_chain_and_tolerance(wire, label, wire.vertices);
  std::vector<VertexPair> missing;
  for (std::size_t i = 0; i + 1 < wire.vertices.size(); ++i) {
    const VertexPair pair{wire.vertices[i], wire.vertices[i + 1]};
    const int edge = edges.find(pair[0], pair[1]);
    if (edge < 0) {
      missing.push_back(pair);
      continue;
    }
    int& owner = wire_of_edge[edge];
    if (owner >= 0) {
      throw FlattenError(ErrorCode::edge_in_two_wires,
                         "The " + name_elements("edge", std::vector<VertexPair>{pair}) + " is in " +
                             name_wires(input.wires, {owner}) +
                             (static_cast<std::size_t>(owner) == w ? " twice" : " and in " + label) +
                             ": an edge has one length, so leave it in one wire only.",
                         {{pair[0], pair[1]}, {pair}, {}});
    }
    owner = static_cast<int>(w);
  }
  if (!missing.empty()) {
    throw FlattenError(ErrorCode::wire_not_an_edge,
                       "The " + label + " runs along " + name_elements("edge", missing) +
                           (missing.size() == 1 ? ", not an edge" : ", not edges") +
                           " of the mesh: consecutive vertices of a wire must share an edge.",
                       {{}, missing, {}});
  }
}

std::vector<VertexPair> pairs_of(const VertexPairs& rows) {
  std::vector<VertexPair> pairs;
  for (const auto& ends : rows.rowwise()) pairs.push_back({ends[0], ends[1]});
  return pairs;
}

/// Sides of edge a-b whose triangles have b after a, if it is a seam or the edge of the surface.
int num_sides_named(const EdgeTable& edges, const std::set<int>& seams, const VertexPair& ends) {
  const int edge = edges.find(ends[0], ends[1]);
  if (edge < 0 || (edges.num_sides(edge) > 1 && seams.count(edge) == 0)) return 0;
  int num_sides = 0;
  for (int j = 0; j < edges.num_sides(edge); ++j) num_sides += edges.from(edges.side(edge, j)) == ends[0] ? 1 : 0;
  return num_sides;
}

/// Each half-edge is one side of the outline, and no other ease has it.
void check_eases(const FlattenInput& input, const EdgeTable& edges) {
  if (input.eases.empty()) return;
  std::set<int> seams;
  for (const VertexPair& ends : pairs_of(input.seams)) seams.insert(edges.find(ends[0], ends[1]));
  std::set<VertexPair> eased;
  std::vector<VertexPair> without_side, twice;
  for (const Ease& ease : input.eases) {
    check_vertices_in_range({ease.half_edges.data(), ease.half_edges.data() + ease.half_edges.size()},
                            input.vertices.rows(), "An ease");
    check_ratio(ease.ratio, "The ease along " + name_elements("edge", pairs_of(ease.half_edges)) + " has a ratio",
                {{}, pairs_of(ease.half_edges), {}});
    for (const VertexPair& ends : pairs_of(ease.half_edges)) {
      if (num_sides_named(edges, seams, ends) != 1) without_side.push_back(ends);
      if (!eased.insert(ends).second) twice.push_back(ends);
    }
  }
  if (!without_side.empty()) {
    throw FlattenError(ErrorCode::ease_without_side,
                       "An ease names " + name_elements("edge", without_side) +
                           ", where there is not just one triangle with these vertices in this order, on a seam or at "
                           "the edge of the surface: name the sides of seams and outlines.",
                       {{}, without_side, {}});
  }
  if (twice.empty()) return;
  throw FlattenError(ErrorCode::side_in_two_eases,
                     "The sides along " + name_elements("edge", twice) +
                         " are in two eases: a side has one length, so leave each in one ease only.",
                     {{}, twice, {}});
}

/// So many parts and less are taken as they are, whatever they are.
constexpr int kManyParts = 1000;

/// Parts of so many triangles each, on average, are single faces: hexagons at most.
constexpr int kTrianglesOfFace = 4;

}  // namespace

void check_wire(const Wire& wire) {
  check_name(wire);
  check_chain_and_tolerance(wire, wire.name.empty() ? "wire" : "wire (" + wire.name + ")", {});
}

void check_ease(const Ease& ease) { check_ratio(ease.ratio, "An ease has a ratio", {}); }

void check_mesh(const FlattenInput& input) {
  if (input.faces.rows() == 0 || input.vertices.rows() == 0) {
    throw FlattenError(ErrorCode::empty_mesh, std::string("The mesh has no ") +
                                                  (input.vertices.rows() == 0 ? "vertices" : "faces") +
                                                  ": there is nothing to flatten.");
  }
  std::set<int> bad_vertices;
  std::vector<int> bad_faces;
  for (int f = 0; f < input.faces.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const int v = input.faces(f, k);
      if (v >= 0 && v < input.vertices.rows()) continue;
      bad_vertices.insert(v);
      if (bad_faces.empty() || bad_faces.back() != f) bad_faces.push_back(f);
    }
  }
  if (!bad_faces.empty()) {
    const std::vector<int> vertices(bad_vertices.begin(), bad_vertices.end());
    throw FlattenError(ErrorCode::vertex_out_of_range,
                       capitalized(name_elements("face", bad_faces)) + (bad_faces.size() == 1 ? " names " : " name ") +
                           name_elements("vertex", vertices) + ", but the mesh has vertices 0 to " +
                           std::to_string(input.vertices.rows() - 1) + ": use indices of this mesh.",
                       {vertices, {}, bad_faces});
  }
  std::vector<int> not_finite;
  for (int v = 0; v < input.vertices.rows(); ++v) {
    // Squared areas of larger ones overflow.
    if (!(input.vertices.row(v).array().abs() < kCoordinateLimit).all()) not_finite.push_back(v);
  }
  if (!not_finite.empty()) {
    throw FlattenError(ErrorCode::non_finite_coordinates,
                       "The coordinates of " + name_elements("vertex", not_finite) +
                           " are not all finite and below 1e60 in magnitude: move or delete them.",
                       {not_finite, {}, {}});
  }
}

void check_faces_share_edges(const FlattenInput& input, const EdgeTable& edges) {
  const auto num_faces = static_cast<int>(input.faces.rows());
  int num_parts = num_faces;
  DisjointSets parts(static_cast<std::size_t>(num_faces));
  for (int e = 0; e < edges.num_edges(); ++e) {
    for (int j = 1; j < edges.num_sides(e); ++j) {
      if (parts.unite(edges.side(e, 0) / 3, edges.side(e, j) / 3)) --num_parts;
    }
  }
  if (num_parts <= kManyParts || num_faces > kTrianglesOfFace * num_parts) return;
  throw FlattenError(ErrorCode::loose_faces,
                     "The " + std::to_string(num_faces) + " triangles of the mesh are " + std::to_string(num_parts) +
                         " separate parts: merge vertices by distance, so that neighboring faces share their edges.");
}

void check_seams_and_wires(const FlattenInput& input, const EdgeTable& edges) {
  check_seams(input, edges);
  std::vector<int> wire_of_edge(edges.num_edges(), -1);
  for (std::size_t w = 0; w < input.wires.size(); ++w) check_wire_on_mesh(input, edges, w, wire_of_edge);
  check_eases(input, edges);
}

}  // namespace wirewarp
