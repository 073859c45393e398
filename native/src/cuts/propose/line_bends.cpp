// SPDX-License-Identifier: GPL-3.0-or-later
#include "cuts/propose/line_bends.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

#include "base/planar.h"

namespace wirewarp {
namespace {

/// Lines are smooth if they turn by less than this angle at each vertex, in radians. A turn of 30 degrees catches the
/// eye on the flat piece.
constexpr double kSmooth = kPi / 6;

/// Returns by how many radians a line turns at v between its vertices `from` and `to`; 0 on an outline. Angles at v are
/// scaled to a total of 2 pi. faces: all faces at v.
double turn_at(const CutMesh& mesh, int v, const std::vector<int>& faces, int from, int to) {
  double left = 0, total = 0;  // angles around v: between `from` and `to`, and all together
  bool has_passed = false;
  int at = from;
  for (std::size_t count = 0; count < faces.size(); ++count) {
    has_passed = has_passed || at == to;
    const auto next = std::find_if(faces.begin(), faces.end(), [&](int f) {
      for (int k = 0; k < 3; ++k) {
        if (mesh.faces(f, k) == v && mesh.faces(f, (k + 1) % 3) == at) return true;
      }
      return false;
    });
    if (next == faces.end()) return 0;
    int k = 0;
    while (mesh.faces(*next, k) != v) ++k;
    const int last = mesh.faces(*next, (k + 2) % 3);
    const Eigen::RowVector3d a = mesh.vertices.row(at) - mesh.vertices.row(v);
    const Eigen::RowVector3d b = mesh.vertices.row(last) - mesh.vertices.row(v);
    const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
    if (!has_passed) left += angle;
    total += angle;
    at = last;
  }
  return at == from ? std::abs(kPi - left * 2 * kPi / total) : 0;
}

}  // namespace

std::vector<int> count_bends(const CutMesh& cut, std::size_t num_lines) {
  struct Passed {
    std::vector<int> neighbors, faces;
    int line = -1;
  };
  std::map<int, Passed> passed;
  for (std::size_t i = 0; i < cut.edges.size(); ++i) {
    const auto& [a, b] = cut.edges[i];
    passed[a].neighbors.push_back(b);
    passed[b].neighbors.push_back(a);
    passed[a].line = passed[b].line = cut.sources.edge_paths[i];
  }
  for (int f = 0; f < static_cast<int>(cut.faces.rows()); ++f) {
    for (const int v : cut.faces.row(f)) {
      const auto found = passed.find(v);
      if (found != passed.end()) found->second.faces.push_back(f);
    }
  }
  std::vector<int> bends(num_lines, 0);
  for (const auto& [v, at] : passed) {
    if (at.neighbors.size() != 2) continue;
    if (turn_at(cut, v, at.faces, at.neighbors[0], at.neighbors[1]) > kSmooth)
      ++bends[static_cast<std::size_t>(at.line)];
  }
  return bends;
}

}  // namespace wirewarp
