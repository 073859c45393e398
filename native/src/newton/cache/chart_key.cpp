// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/cache/chart_key.h"

#include <map>
#include <type_traits>
#include <utility>

#include "surface/charts/slits.h"

namespace wirewarp {
namespace {

class KeyWriter {
 public:
  template <class Value>
  void write(const Value& value) {
    static_assert(std::is_arithmetic_v<Value> || std::is_enum_v<Value>, "other types may have padding between bytes");
    key_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }

  /// The number of items comes first. Otherwise, the lists [a, b], [c] and the lists [a], [b, c] would have the same
  /// bytes.
  template <class List, class Write>
  void write_list(const List& list, const Write& write_item) {
    write(list.size());
    for (const auto& item : list) write_item(item);
  }

  /// Writes a list of numbers in one block, because a key consists mostly of the numbers of a mesh.
  template <class Number>
  void write_numbers(const std::vector<Number>& numbers) {
    static_assert(std::is_arithmetic_v<Number>, "other types may have padding between bytes");
    write(numbers.size());
    key_.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number));
  }

  void write_chain(const HalfEdgeChain& chain) {
    write_list(chain, [&](HalfedgeHandle h) { write(h.idx()); });
  }

  std::string take() { return std::move(key_); }

 private:
  std::string key_;
};

void write_mesh(const HalfEdgeMesh& mesh, KeyWriter& key) {
  std::vector<int> numbers;
  numbers.reserve(mesh.n_vertices() + 3 * mesh.n_halfedges() + mesh.n_faces());
  for (const VertexHandle v : mesh.vertices()) numbers.push_back(mesh.halfedge_handle(v).idx());
  for (const HalfedgeHandle h : mesh.halfedges()) {
    numbers.push_back(mesh.to_vertex_handle(h).idx());
    numbers.push_back(mesh.next_halfedge_handle(h).idx());
    numbers.push_back(mesh.face_handle(h).idx());
  }
  for (const FaceHandle f : mesh.faces()) numbers.push_back(mesh.halfedge_handle(f).idx());
  std::vector<double> coordinates;
  coordinates.reserve(3 * mesh.n_vertices());
  for (const VertexHandle v : mesh.vertices()) {
    for (const double x : mesh.point(v)) coordinates.push_back(x);
  }
  key.write_numbers(coordinates);
  key.write_numbers(numbers);
}

/// Writes the fabric, and the options that determine the direction of the fabric on the chart. Does not write the
/// stretch, because the cache keeps solutions without the stretch.
void write_cloth(const Chart& chart, const Options& options, KeyWriter& key) {
  key.write(options.cloth.has_value());
  if (!options.cloth) return;
  const Cloth& cloth = *options.cloth;
  for (const double number : {cloth.weft, cloth.warp, cloth.shear, cloth.squeeze}) key.write(number);
  key.write(cloth.locking.has_value());
  if (cloth.locking) key.write(*cloth.locking);
  key.write(options.orientation);
  key.write(options.grain_angle);
  for (const double coordinate : options.up) key.write(coordinate);
  for (const WirePart& part : chart.wire_parts) key.write(part.wire_index == options.grain);
}

/// Numbers the sections of elastic seams. The sides of a section share one length and one number.
class SharedLengths {
 public:
  int number_of(const WirePart& part) {
    return numbers_.insert({{part.wire_index, part.part}, static_cast<int>(numbers_.size())}).first->second;
  }

 private:
  std::map<std::pair<int, int>, int> numbers_;
};

void write_chart(const Chart& chart, SharedLengths& shared, KeyWriter& key) {
  key.write_list(chart.wire_parts, [&](const WirePart& part) {
    key.write(part.kind);
    key.write(part.tolerance);
    key.write(part.ease);
    if (is_elastic_boundary(part)) key.write(shared.number_of(part));
    key.write_chain(part.half_edges);
  });
  key.write_numbers(chart.length_ratio);
  key.write_list(chart.boundary_loops, [&](const HalfEdgeChain& loop) { key.write_chain(loop); });
  key.write_list(chart.boundary_chains, [&](const BoundaryChain& chain) { key.write_chain(chain.half_edges); });
  key.write_list(find_slits(chart),
                 [&](const Slit& slit) {  // slits depend on the input's vertices, which are not in the key
                   key.write_chain(slit.rims);
                   key.write_numbers(slit.mate);
                 });
  write_mesh(chart.mesh, key);
}

}  // namespace

std::string solution_key(const std::vector<const Chart*>& group, const Options& options) {
  KeyWriter key;
  key.write(options.method);
  key.write(options.node_weight);
  key.write(options.inner);
  key.write(options.fairness);
  key.write(options.max_factorizations);
  SharedLengths shared;
  key.write_list(group, [&](const Chart* chart) {
    write_cloth(*chart, options, key);
    write_chart(*chart, shared, key);
  });
  return key.take();
}

std::string name_key(const std::vector<const Chart*>& group, const std::vector<Wire>& wires) {
  KeyWriter key;
  key.write_list(group, [&](const Chart* chart) {
    key.write_numbers(chart->source_vertex);
    key.write_numbers(chart->source_face);
    key.write_list(chart->wire_parts, [&](const WirePart& part) {
      key.write(part.wire_index);
      key.write_list(wires[part.wire_index].name, [&](char letter) { key.write(letter); });
    });
  });
  return key.take();
}

}  // namespace wirewarp
