// SPDX-License-Identifier: GPL-3.0-or-later
#include "closed_meshes.h"

#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "base/planar.h"
#include "test_meshes.h"

namespace wirewarp::test {

FlattenInput closed_surface(int around, int rings, const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& shape,
                            const std::function<bool(int, int)>& rises) {
  FlattenInput input;
  const int top = 1 + around * (rings - 1);
  input.vertices.resize(top + 1, 3);
  input.vertices.row(0) = shape(-Eigen::Vector3d::UnitZ());
  input.vertices.row(top) = shape(Eigen::Vector3d::UnitZ());
  std::vector<Eigen::RowVector3i> faces;
  const auto at = [&](int i, int j) { return 1 + (j - 1) * around + i % around; };
  for (int i = 0; i < around; ++i) {
    faces.emplace_back(0, at(i + 1, 1), at(i, 1));
    faces.emplace_back(top, at(i, rings - 1), at(i + 1, rings - 1));
    for (int j = 1; j < rings; ++j) {
      const double angle = 2 * kPi * i / around, down = kPi * j / rings;
      input.vertices.row(at(i, j)) =
          shape({std::sin(down) * std::cos(angle), std::sin(down) * std::sin(angle), -std::cos(down)});
      if (j + 1 == rings) continue;
      const int a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      faces.emplace_back(a, b, rises(i, j) ? c : d);
      faces.emplace_back(rises(i, j) ? a : b, c, d);
    }
  }
  input.faces.resize(faces.size(), 3);
  for (std::size_t f = 0; f < faces.size(); ++f) input.faces.row(f) = faces[f];
  return input;
}

FlattenInput cubes(int nx, int ny, int nz, const std::function<bool(int, int, int)>& is_solid) {
  const std::array<int, 3> size{nx, ny, nz};
  std::map<std::array<int, 3>, int> index;
  std::vector<std::array<int, 3>> faces;
  const auto solid = [&](const std::array<int, 3>& c) {
    for (std::size_t a = 0; a < 3; ++a) {
      if (c[a] < 0 || c[a] >= size[a]) return false;
    }
    return is_solid(c[0], c[1], c[2]);
  };
  const auto vertex = [&](const std::array<int, 3>& p) {
    return index.emplace(p, static_cast<int>(index.size())).first->second;
  };
  for (int cell = 0; cell < nx * ny * nz; ++cell) {
    const std::array<int, 3> c{cell % nx, cell / nx % ny, cell / nx / ny};
    if (!solid(c)) continue;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const int side : {0, 1}) {
        std::array<int, 3> beside = c;
        beside[axis] += 2 * side - 1;
        if (solid(beside)) continue;
        std::array<int, 4> quad{};
        for (std::size_t k = 0; k < 4; ++k) {
          std::array<int, 3> corner = c;
          corner[axis] += side;
          corner[(axis + 1) % 3] += k == 1 || k == 2;
          corner[(axis + 2) % 3] += k >= 2;
          quad[side == 1 ? k : 3 - k] = vertex(corner);
        }
        faces.push_back({quad[0], quad[1], quad[2]});
        faces.push_back({quad[0], quad[2], quad[3]});
      }
    }
  }
  std::vector<std::array<double, 3>> points(index.size());
  for (const auto& [p, v] : index) points[v] = {1.0 * p[0], 1.0 * p[1], 1.0 * p[2]};
  return mesh_of(points, faces);
}

FlattenInput beside(FlattenInput first, const FlattenInput& second, double apart) {
  const auto count = static_cast<int>(first.vertices.rows());
  first.vertices.conservativeResize(count + second.vertices.rows(), 3);
  first.vertices.bottomRows(second.vertices.rows()) = second.vertices.rowwise() + Eigen::RowVector3d(apart, 0, 0);
  first.faces.conservativeResize(first.faces.rows() + second.faces.rows(), 3);
  first.faces.bottomRows(second.faces.rows()) = second.faces.array() + count;
  first.seams.conservativeResize(first.seams.rows() + second.seams.rows(), 2);
  first.seams.bottomRows(second.seams.rows()) = second.seams.array() + count;
  return first;
}

}  // namespace wirewarp::test
