// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference_cases.h"

#include <array>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

#include "test_meshes.h"

namespace wirewarp::test {
namespace {

/// Vertices and triangles of a Wavefront OBJ.
FlattenInput read_obj(std::istream& file) {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<int, 3>> faces;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "v") {
      double x = 0, y = 0, z = 0;
      words >> x >> y >> z;
      vertices.emplace_back(x, y, z);
    }
    if (kind != "f") continue;
    std::array<std::string, 3> corners;  // such as 7/3/1: vertex, texture, normal, from 1
    words >> corners[0] >> corners[1] >> corners[2];
    faces.push_back({std::stoi(corners[0]) - 1, std::stoi(corners[1]) - 1, std::stoi(corners[2]) - 1});
  }
  FlattenInput input;
  input.vertices.resize(static_cast<Eigen::Index>(vertices.size()), 3);
  input.faces.resize(static_cast<Eigen::Index>(faces.size()), 3);
  for (int v = 0; v < input.vertices.rows(); ++v) input.vertices.row(v) = vertices[v];
  for (int f = 0; f < input.faces.rows(); ++f) input.faces.row(f) << faces[f][0], faces[f][1], faces[f][2];
  return input;
}

/// The chains of a JSON file: the lists of numbers after its keys "vertices".
std::vector<std::vector<int>> read_wires(std::istream& file) {
  std::vector<std::vector<int>> wires;
  for (std::string word; file >> word;) {
    if (word != "\"vertices\":") continue;
    std::vector<int>& wire = wires.emplace_back();
    char mark = 0;  // [ or , before a vertex, ] after the last
    for (int vertex = 0; file >> mark && mark != ']' && file >> vertex;) wire.push_back(vertex);
  }
  return wires;
}

/// To behind a text.
void skip_past(std::istream& file, const std::string& text) {
  std::string seen;
  for (char letter = 0; file.get(letter);) {
    seen += letter;
    if (seen.size() > text.size()) seen.erase(0, 1);
    if (seen == text) return;
  }
}

/// The next list of a JSON file: numbers between brackets, or none at another bracket's end.
std::optional<std::vector<double>> read_numbers(std::istream& file) {
  char mark = 0;  // between the lists: , and the outer brackets
  while (file >> mark && mark != '[') {
    if (mark == ']') return std::nullopt;
  }
  std::vector<double> numbers;
  for (double number = 0; file >> number;) {
    numbers.push_back(number);
    file >> mark;
    if (mark == ']') break;
  }
  return numbers;
}

/// The rows of the list of lists after a key.
template <typename Row>
void read_rows(std::istream& file, const std::string& key, Row&& take_row) {
  skip_past(file, '"' + key + "\":[");
  while (const std::optional<std::vector<double>> row = read_numbers(file)) take_row(*row);
}

}  // namespace

std::optional<FlattenInput> reference_panel(const std::string& name, double tolerance) {
  const std::filesystem::path panels = std::filesystem::path(WIREWARP_REPOSITORY) / ".." / "shared/meshes/_panels";
  if (!std::filesystem::exists(panels)) return std::nullopt;
  std::ifstream mesh(panels / (name + ".obj")), wires(panels / (name + ".wires.json"));
  FlattenInput input = read_obj(mesh);
  for (const std::vector<int>& wire : read_wires(wires)) add_wire(input, wire, tolerance);
  return input;
}

std::vector<FlattenInput> reference_panels(const std::vector<std::string>& names, double tolerance) {
  std::vector<FlattenInput> panels;
  for (const std::string& name : names) {
    if (const std::optional<FlattenInput> panel = reference_panel(name, tolerance)) panels.push_back(*panel);
  }
  return panels;
}

std::optional<FlattenInput> reference_request(const std::string& name) {
  std::ifstream file(std::filesystem::path(WIREWARP_REPOSITORY) / ".." / "shared/cases" / (name + ".json"));
  if (!file) return std::nullopt;
  std::vector<Eigen::RowVector3d> vertices;
  std::vector<Eigen::RowVector3i> faces;
  read_rows(file, "vertices", [&](const std::vector<double>& p) { vertices.emplace_back(p.at(0), p.at(1), p.at(2)); });
  read_rows(file, "faces", [&](const std::vector<double>& f) {
    faces.push_back(Eigen::RowVector3d(f.at(0), f.at(1), f.at(2)).cast<int>());
  });
  FlattenInput input;
  input.vertices.resize(static_cast<Eigen::Index>(vertices.size()), 3);
  input.faces.resize(static_cast<Eigen::Index>(faces.size()), 3);
  for (int v = 0; v < input.vertices.rows(); ++v) input.vertices.row(v) = vertices[v];
  for (int f = 0; f < input.faces.rows(); ++f) input.faces.row(f) = faces[f];
  for (skip_past(file, "\"vertices\":"); file; skip_past(file, "\"vertices\":")) {
    const std::vector<double> chain = read_numbers(file).value();
    skip_past(file, "\"tolerance\":");
    double tolerance = 0;
    file >> tolerance;
    add_wire(input, {chain.begin(), chain.end()}, tolerance);
  }
  return input;
}

}  // namespace wirewarp::test
