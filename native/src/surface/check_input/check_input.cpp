// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/check_input/check_input.h"

#include <cmath>
#include <set>

#include "base/arguments.h"
#include "base/disjoint_sets.h"
#include "base/sentence.h"
#include "surface/mesh/vertex_pairs.h"

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
                     ErrorArguments{{"name", owner}, {"num_vertices", static_cast<int>(num_vertices)}}, {bad, {}, {}});
}

void check_seams(const FlattenInput& input, const EdgeTable& edges) {
  const std::vector<int> ends(input.seams.data(), input.seams.data() + input.seams.size());
  check_vertices_in_range(ends, input.vertices.rows(), "the list of seams");
  std::vector<VertexPair> bad;
  for (const VertexPair& pair : as_list(input.seams)) {
    if (edges.find(pair[0], pair[1]) < 0) bad.push_back(pair);
  }
  if (bad.empty()) return;
  throw FlattenError(ErrorCode::seam_not_an_edge, ErrorArguments{}, {{}, bad, {}});
}

/// Throws invalid_type if a name contains the character '\0', which would end error sentences early.
void check_name(const Wire& wire) {
  if (wire.name.find('\0') == std::string::npos) return;
  throw FlattenError(ErrorCode::invalid_type, ErrorArguments{{"name", "The name of a wire"},
                                                             {"wanted", "text without NUL characters"},
                                                             {"found", "text with a NUL character"}});
}

bool leaves_length(double ease) { return std::isfinite(ease) && ease > -1; }

/// Checks the number of vertices, the tolerance and the ease of a wire. named: arguments that identify the wire.
/// vertices: vertices of the mesh, for the error.
void check_chain_and_tolerance(const Wire& wire, ErrorArguments named, const std::vector<int>& vertices) {
  if (wire.vertices.size() < 2) throw FlattenError(ErrorCode::wire_too_short, std::move(named), {vertices, {}, {}});
  if (!(wire.tolerance >= 0)) {
    named["tolerance"] = wire.tolerance;
    throw FlattenError(ErrorCode::invalid_tolerance, std::move(named), {vertices, {}, {}});
  }
  if (!leaves_length(wire.ease)) {
    named["ease"] = wire.ease;
    throw FlattenError(ErrorCode::invalid_ease, std::move(named), {vertices, {}, {}});
  }
}

void check_wire_on_mesh(const FlattenInput& input, const EdgeTable& edges, std::size_t w,
                        std::vector<int>& wire_of_edge) {
  const Wire& wire = input.wires[w];
  check_name(wire);
  const auto index = static_cast<int>(w);
  check_vertices_in_range(wire.vertices, input.vertices.rows(), "the " + name_wires({index}, {wire.name}));
  check_chain_and_tolerance(wire, arguments_of_wires(input.wires, {index}), wire.vertices);
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
      std::vector<int> owners = {owner};
      if (owner != index) owners.push_back(index);
      throw FlattenError(ErrorCode::edge_in_two_wires, arguments_of_wires(input.wires, owners),
                         {{pair[0], pair[1]}, {pair}, {}});
    }
    owner = index;
  }
  if (!missing.empty()) {
    throw FlattenError(ErrorCode::wire_not_an_edge, arguments_of_wires(input.wires, {index}), {{}, missing, {}});
  }
}

/// Returns how many sides of an edge have a triangle with ends[1] after ends[0]; 0 if the edge is not on a seam or
/// border.
int num_sides_named(const EdgeTable& edges, const std::set<int>& seams, const VertexPair& ends) {
  const int edge = edges.find(ends[0], ends[1]);
  if (edge < 0 || (edges.num_sides(edge) > 1 && seams.count(edge) == 0)) return 0;
  int num_sides = 0;
  for (int j = 0; j < edges.num_sides(edge); ++j) num_sides += edges.from(edges.side(edge, j)) == ends[0] ? 1 : 0;
  return num_sides;
}

FlattenError wrong_ratio(double ratio, std::vector<VertexPair> half_edges) {
  return FlattenError(ErrorCode::invalid_ease, ErrorArguments{{"ease", ratio}}, {{}, std::move(half_edges), {}});
}

/// Checks that each half-edge is exactly one side of the outline and has no other ease.
void check_eases(const FlattenInput& input, const EdgeTable& edges) {
  if (input.eases.empty()) return;
  std::set<int> seams;
  for (const VertexPair& ends : as_list(input.seams)) seams.insert(edges.find(ends[0], ends[1]));
  std::set<VertexPair> eased;
  std::vector<VertexPair> without_side, twice;
  for (const Ease& ease : input.eases) {
    check_vertices_in_range({ease.half_edges.data(), ease.half_edges.data() + ease.half_edges.size()},
                            input.vertices.rows(), "an ease");
    if (!leaves_length(ease.ratio)) throw wrong_ratio(ease.ratio, as_list(ease.half_edges));
    for (const VertexPair& ends : as_list(ease.half_edges)) {
      if (num_sides_named(edges, seams, ends) != 1) without_side.push_back(ends);
      if (!eased.insert(ends).second) twice.push_back(ends);
    }
  }
  if (!without_side.empty()) {
    throw FlattenError(ErrorCode::ease_without_side, ErrorArguments{}, {{}, without_side, {}});
  }
  if (twice.empty()) return;
  throw FlattenError(ErrorCode::side_in_two_eases, ErrorArguments{}, {{}, twice, {}});
}

/// Meshes with up to this many parts are accepted. Intentional parts are at most a few hundred. A file with separate
/// faces has one part per face, and its result would be useless and slow.
constexpr int kManyParts = 1000;

/// Parts with at most this many triangles on average count as single faces (a hexagon has four triangles).
constexpr int kTrianglesOfFace = 4;

}  // namespace

void check_wire(const Wire& wire) {
  check_name(wire);
  const std::vector<std::string> names(wire.name.empty() ? 0 : 1, wire.name);
  check_chain_and_tolerance(wire, {{"wires", std::vector<int>()}, {"wire_names", names}}, {});
}

void check_ease(const Ease& ease) {
  if (!leaves_length(ease.ratio)) throw wrong_ratio(ease.ratio, {});
}

void check_mesh(const FlattenInput& input) {
  if (input.faces.rows() == 0 || input.vertices.rows() == 0) {
    throw FlattenError(ErrorCode::empty_mesh, ErrorArguments{{"num_vertices", static_cast<int>(input.vertices.rows())},
                                                             {"num_faces", static_cast<int>(input.faces.rows())}});
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
    throw FlattenError(
        ErrorCode::vertex_out_of_range,
        ErrorArguments{{"name", "the list of faces"}, {"num_vertices", static_cast<int>(input.vertices.rows())}},
        {vertices, {}, bad_faces});
  }
  std::vector<int> not_finite;
  for (int v = 0; v < input.vertices.rows(); ++v) {
    if (!(input.vertices.row(v).array().abs() < kCoordinateLimit).all()) not_finite.push_back(v);
  }
  if (!not_finite.empty()) {
    throw FlattenError(ErrorCode::non_finite_coordinates, ErrorArguments{{"limit", kCoordinateLimit}},
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
  std::vector<int> size(static_cast<std::size_t>(num_faces), 0), loose;
  for (int f = 0; f < num_faces; ++f) ++size[parts.find(f)];
  for (int f = 0; f < num_faces; ++f) {
    if (size[parts.find(f)] <= kTrianglesOfFace) loose.push_back(f);
  }
  throw FlattenError(ErrorCode::loose_faces, ErrorArguments{{"num_faces", num_faces}, {"num_parts", num_parts}},
                     {{}, {}, std::move(loose)});
}

void check_seams_and_wires(const FlattenInput& input, const EdgeTable& edges) {
  check_seams(input, edges);
  std::vector<int> wire_of_edge(edges.num_edges(), -1);
  for (std::size_t w = 0; w < input.wires.size(); ++w) check_wire_on_mesh(input, edges, w, wire_of_edge);
  check_eases(input, edges);
}

}  // namespace wirewarp
