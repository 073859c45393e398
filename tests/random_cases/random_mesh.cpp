// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>

#include "base/planar.h"
#include "random_input.h"

namespace wirewarp::test {
namespace {

/// Returns the positions of grid lines in [0, 1]: evenly spaced, random, or denser towards 0.
std::vector<double> grid_lines(RandomStream& random, int count) {
  std::vector<double> lines;
  const int kind = random.below(4);
  const double ratio = std::max(random.between(0.3, 0.9), std::pow(1e-9, 1.0 / count));
  for (int i = 0; i <= count; ++i) {
    const double even = static_cast<double>(i) / count;
    if (kind == 0 && i > 0 && i < count) {
      lines.push_back(even + random.between(-0.45, 0.45) / count);
    } else if (kind == 1) {
      lines.push_back(i == 0 ? 0 : std::pow(ratio, count - i));
    } else {
      lines.push_back(even);
    }
  }
  return lines;
}

/// Returns a triangulated grid of nx by ny quads.
///
/// wraps_s, wraps_t: whether the last points in this direction are the first points
/// place(s, t): position of a grid point
template <typename Place>
MeshPart make_grid(RandomStream& random, int nx, int ny, bool wraps_s, bool wraps_t, const Place& place) {
  const std::vector<double> s = grid_lines(random, nx), t = grid_lines(random, ny);
  const int columns = wraps_s ? nx : nx + 1, rows = wraps_t ? ny : ny + 1;
  MeshPart mesh;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      mesh.vertices.push_back(place(s[i], t[j]));
    }
  }
  const auto index = [&](int i, int j) { return i % columns + columns * (j % rows); };
  const int diagonals = random.below(3);
  for (int j = 0; j < ny; ++j) {
    for (int i = 0; i < nx; ++i) {
      const int a = index(i, j), b = index(i + 1, j), c = index(i + 1, j + 1), d = index(i, j + 1);
      if (diagonals == 2 ? random.chance(0.5) : diagonals == 1) {
        mesh.faces.insert(mesh.faces.end(), {{a, b, d}, {b, c, d}});
      } else {
        mesh.faces.insert(mesh.faces.end(), {{a, b, c}, {a, c, d}});
      }
    }
  }
  return mesh;
}

std::function<double(double, double)> random_height(RandomStream& random) {
  const double high = random.across_scales(0.01, 1.5);
  const double fx = random.between(0.3, 4), fy = random.between(0.3, 4);
  switch (random.below(5)) {
    case 0:
      return [](double, double) { return 0.0; };
    case 1:
      return [=](double x, double) { return high * std::sin(fx * x); };
    case 2:
      return [=](double x, double y) { return high * std::cos(kPi * (x - 0.5)) * std::cos(kPi * (y - 0.5)); };
    case 3:
      return [=](double x, double y) { return high * ((x - 0.5) * (x - 0.5) - (y - 0.5) * (y - 0.5)); };
    default:
      return [=](double x, double y) { return 0.3 * high * std::sin(fx * kPi * x) * std::sin(fy * kPi * y); };
  }
}

MeshPart random_sheet(RandomStream& random) {
  const auto height = random_height(random);
  const double width = random.across_scales(0.05, 20);
  const bool jitters = random.chance(0.3);
  const bool is_huge = random.chance(0.006);  // 20,000 faces or more, solved from coarse to fine
  const int most = is_huge ? 120 : random.chance(0.03) ? 45 : 12;
  const int least = is_huge ? 100 : 1, nx = random.whole(least, most), ny = random.whole(least, most);
  RandomStream shake(static_cast<std::uint64_t>(random.below(1 << 30)));
  return make_grid(random, nx, ny, false, false, [&](double s, double t) {
    const double lift = jitters ? shake.between(-0.6, 0.6) / most : 0;
    return Eigen::Vector3d(width * s, t, height(s, t) + lift);
  });
}

/// Returns a sheet without one to three quads inside. The remaining faces never touch only at a vertex.
MeshPart sheet_with_holes(RandomStream& random) {
  const int holes = random.whole(1, 3);
  const auto height = random_height(random);
  const int nx = 3 * holes + 1 + random.whole(0, 6);
  const int ny = random.whole(4, 9);
  MeshPart mesh = make_grid(random, nx, ny, false, false,
                            [&](double s, double t) { return Eigen::Vector3d(2 * s, t, 0.5 * height(s, t)); });
  std::vector<char> removed(mesh.faces.size(), 0);
  for (int hole = 0; hole < holes; ++hole) {  // one quad, two columns apart from other holes, not at the outline
    const int quad = 1 + 3 * hole + nx * random.whole(1, ny - 2);
    removed[2 * quad] = removed[2 * quad + 1] = 1;
  }
  std::vector<std::array<int, 3>> kept;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    if (!removed[f]) kept.push_back(mesh.faces[f]);
  }
  mesh.faces = std::move(kept);
  return mesh;
}

MeshPart random_tube(RandomStream& random) {
  const double high = random.across_scales(0.05, 5);
  const double taper = random.chance(0.5) ? random.between(-0.9, 0.9) : 0;
  const double belly = random.between(-0.5, 0.5);
  const bool is_ring = random.chance(0.15);  // whether the ends of the tube meet, as in a torus
  const int around = random.whole(3, 14);
  const int along = is_ring ? random.whole(3, 10) : random.whole(1, 10);
  return make_grid(random, around, along, true, is_ring, [&](double s, double t) {
    const double angle = 2 * kPi * s;
    if (is_ring) {
      const double turn = -2 * kPi * t;
      const double radius = 1 + 0.4 * std::cos(angle);
      return Eigen::Vector3d(radius * std::cos(turn), radius * std::sin(turn), 0.4 * std::sin(angle));
    }
    const double radius = 1 + taper * (t - 0.5) + belly * std::sin(kPi * t);
    return Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), high * t);
  });
}

/// Returns a tube with fans that close both ends, or only the lower end.
MeshPart random_ball(RandomStream& random) {
  const int around = random.whole(3, 12);
  const int along = random.whole(1, 8);
  MeshPart mesh = make_grid(random, around, along, true, false, [&](double s, double t) {
    const double latitude = kPi * (0.1 + 0.8 * t - 0.5);
    return Eigen::Vector3d(std::cos(latitude) * std::cos(2 * kPi * s), std::cos(latitude) * std::sin(2 * kPi * s),
                           std::sin(latitude));
  });
  const int south = static_cast<int>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), {{0, 0, -1}, {0, 0, 1}});
  const int top = around * along;
  const bool is_open = random.chance(0.3);  // a bowl
  for (int i = 0; i < around; ++i) {
    const int next = (i + 1) % around;
    mesh.faces.push_back({south, next, i});
    if (!is_open) mesh.faces.push_back({south + 1, top + i, top + next});
  }
  if (is_open) mesh.vertices.pop_back();
  return mesh;
}

MeshPart random_fan(RandomStream& random) {
  const int blades = random.whole(1, 12);
  const double turn = random.between(0.2, 1.9) * kPi / blades;
  const double rise = random.between(-0.5, 0.5);
  MeshPart mesh;
  mesh.vertices.push_back({0, 0, 0});
  for (int i = 0; i <= blades; ++i) {
    const double radius = random.between(0.3, 1);
    mesh.vertices.push_back({radius * std::cos(turn * i), radius * std::sin(turn * i), rise * (i % 2)});
    if (i > 0) mesh.faces.push_back({0, i, i + 1});
  }
  return mesh;
}

MeshPart random_part(RandomStream& random, std::string& description) {
  const auto named = [&](const char* name, MeshPart (*make)(RandomStream&)) {
    description += name;
    return make(random);
  };
  const int kind = random.below(12);
  if (kind < 3) return named(" sheet", random_sheet);
  if (kind == 3) return named(" sheet-with-holes", sheet_with_holes);
  if (kind < 6) return named(" tube", random_tube);
  if (kind == 6) return named(" ball", random_ball);
  return kind < 11 ? rough_sheet(random, description) : named(" fan", random_fan);
}

/// Returns the mesh rotated, scaled and moved. May also renumber vertices and faces, and start faces at any corner.
FlattenInput anywhere(RandomStream& random, const MeshPart& mesh, std::string& description) {
  const double size = random.chance(0.3) ? random.across_scales(1e-4, 1e5) : 1;
  const double away = random.chance(0.15) ? random.across_scales(1, 1e6) : 0;
  if (size != 1) description += " scaled";
  if (away != 0) description += " far";
  const Eigen::Vector3d axis =
      Eigen::Vector3d(random.between(-1, 1), random.between(-1, 1), random.between(0.1, 1)).normalized();
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(random.between(-kPi, kPi), axis).toRotationMatrix();
  const bool renumbers = random.chance(0.5);

  std::vector<int> place(mesh.vertices.size());
  std::iota(place.begin(), place.end(), 0);
  if (renumbers) random.shuffle(place);
  FlattenInput input;
  input.vertices.resize(place.size(), 3);
  for (std::size_t v = 0; v < place.size(); ++v) {
    input.vertices.row(place[v]) = size * (turn * mesh.vertices[v] + away * Eigen::Vector3d(1, -2, 0.5)).transpose();
  }
  std::vector<std::array<int, 3>> faces = mesh.faces;
  if (renumbers) random.shuffle(faces);
  input.faces.resize(faces.size(), 3);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const int first = renumbers ? random.below(3) : 0;
    for (int k = 0; k < 3; ++k) input.faces(f, k) = place[faces[f][(k + first) % 3]];
  }
  return input;
}

}  // namespace

FlattenInput random_mesh(RandomStream& random, std::string& description) {
  MeshPart whole;
  const int parts = random.chance(0.7) ? 1 : random.whole(2, 3);
  for (int i = 0; i < parts; ++i) {
    const MeshPart part = random_part(random, description);
    const int offset = static_cast<int>(whole.vertices.size());
    // Parts may be in the same place, because coincident vertices are never welded.
    const double aside = random.chance(0.3) ? 0 : 30.0 * i;
    for (const Eigen::Vector3d& vertex : part.vertices) whole.vertices.push_back(vertex + Eigen::Vector3d(aside, 0, 0));
    for (const auto& [a, b, c] : part.faces) whole.faces.push_back({a + offset, b + offset, c + offset});
  }
  if (random.chance(0.1)) whole.vertices.push_back({5, 5, 5});  // a vertex that no face uses
  return anywhere(random, whole, description);
}

}  // namespace wirewarp::test
