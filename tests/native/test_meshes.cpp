// SPDX-License-Identifier: GPL-3.0-or-later
#include "test_meshes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>

#include "base/planar.h"
#include "surface/charts/cut_into_charts.h"
#include "surface/mesh/edge_table.h"

namespace wirewarp::test {
namespace {

/// Returns the triangles of a grid of quads. num_columns: vertices in a row. If num_columns is nx, rows wrap around.
Triangles grid_faces(int nx, int ny, int num_columns) {
  Triangles faces(2 * nx * ny, 3);
  int f = 0;
  for (int j = 0; j < ny; ++j) {
    for (int i = 0; i < nx; ++i) {
      const int next = (i + 1) % num_columns, below = num_columns * j, above = below + num_columns;
      const int a = i + below, b = next + below, c = next + above, d = i + above;
      faces.row(f++) << a, b, c;
      faces.row(f++) << a, c, d;
    }
  }
  return faces;
}

FlattenInput make_mesh(int nx, int ny, int num_columns, const Surface& surface) {
  FlattenInput input;
  input.vertices.resize(num_columns * (ny + 1), 3);
  for (int j = 0; j <= ny; ++j) {
    for (int i = 0; i < num_columns; ++i) {
      input.vertices.row(i + num_columns * j) = surface(static_cast<double>(i) / nx, static_cast<double>(j) / ny);
    }
  }
  input.faces = grid_faces(nx, ny, num_columns);
  return input;
}

/// Returns first, first + step, first + 2 step and so on.
std::vector<int> arithmetic(int first, int step, int count) {
  std::vector<int> numbers;
  for (int i = 0; i < count; ++i) numbers.push_back(first + step * i);
  return numbers;
}

Eigen::Vector3d on_sphere(double longitude, double latitude) {
  return {std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude), std::sin(latitude)};
}

}  // namespace

FlattenInput make_grid(int nx, int ny, const Surface& surface) { return make_mesh(nx, ny, nx + 1, surface); }

FlattenInput jittered_grid(int n, double jitter, const Surface& surface) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> move(-jitter / n, jitter / n);
  int vertex = 0;
  return make_grid(n, n, [&](double s, double t) {
    const int i = vertex % (n + 1), j = vertex / (n + 1);
    ++vertex;
    const double ds = move(random), dt = move(random);
    return surface(i == 0 || i == n ? s : s + ds, j == 0 || j == n ? t : t + dt);
  });
}

FlattenInput mesh_of(const std::vector<std::array<double, 3>>& points, const std::vector<std::array<int, 3>>& faces) {
  FlattenInput input;
  input.vertices.resize(points.size(), 3);
  input.faces.resize(faces.size(), 3);
  for (int v = 0; v < input.vertices.rows(); ++v) input.vertices.row(v) << points[v][0], points[v][1], points[v][2];
  for (int f = 0; f < input.faces.rows(); ++f) input.faces.row(f) << faces[f][0], faces[f][1], faces[f][2];
  return input;
}

void alternate_diagonals(FlattenInput& grid, int nx) {
  for (int f = 0; f < grid.faces.rows(); f += 2) {
    const int quad = f / 2;
    if ((quad % nx + quad / nx) % 2 == 0) continue;
    const int a = grid.faces(f, 0), b = grid.faces(f, 1), c = grid.faces(f, 2), d = grid.faces(f + 1, 2);
    grid.faces.row(f) << a, b, d;
    grid.faces.row(f + 1) << b, c, d;
  }
}

FlattenInput make_tube(int nx, int ny, const Surface& surface) { return make_mesh(nx, ny, nx, surface); }

std::vector<int> section(const std::vector<int>& chain, int first, int last) {
  return {chain.begin() + first, chain.begin() + last + 1};
}

std::vector<int> grid_row(int nx, int j) { return arithmetic((nx + 1) * j, 1, nx + 1); }

std::vector<int> grid_column(int nx, int ny, int i) { return arithmetic(i, nx + 1, ny + 1); }

std::vector<int> grid_square(int nx, int i, int j, int k) {
  std::vector<int> chain;
  const auto add = [&](int x, int y) { chain.push_back(i + x + (nx + 1) * (j + y)); };
  for (int x = -k; x < k; ++x) add(x, -k);
  for (int y = -k; y < k; ++y) add(k, y);
  for (int x = k; x > -k; --x) add(x, k);
  for (int y = k; y >= -k; --y) add(-k, y);
  return chain;
}

std::vector<int> tube_ring(int nx, int j) {
  std::vector<int> chain = arithmetic(nx * j, 1, nx);
  chain.push_back(chain.front());
  return chain;
}

std::vector<int> tube_line(int nx, int ny, int i) { return arithmetic(i, nx, ny + 1); }

void add_seam(FlattenInput& input, const std::vector<int>& chain) {
  Eigen::Index row = input.seams.rows();
  input.seams.conservativeResize(row + chain.size() - 1, 2);
  for (std::size_t i = 1; i < chain.size(); ++i) input.seams.row(row++) << chain[i - 1], chain[i];
}

void add_wire(FlattenInput& input, const std::vector<int>& chain, double tolerance, const std::string& name) {
  input.wires.push_back({chain, tolerance, name});
}

void add_net(FlattenInput& grid, int n, const std::vector<int>& lines, double tolerance) {
  for (const int line : lines) {
    add_wire(grid, grid_row(n, line), tolerance);
    add_wire(grid, grid_column(n, n, line), tolerance);
  }
}

void add_wires_on_edges(FlattenInput& input, double tolerance,
                        const std::function<bool(const Eigen::Vector3d& middle)>& is_in_region) {
  const EdgeTable edges(input.faces, static_cast<int>(input.vertices.rows()));
  for (int e = 0; e < edges.num_edges(); ++e) {
    const auto [a, b] = edges.vertices(e);
    const bool is_in = !is_in_region || is_in_region((input.vertices.row(a) + input.vertices.row(b)) / 2);
    if (is_in && edges.num_sides(e) == 2) add_wire(input, {a, b}, tolerance);
  }
}

FlattenInput keep_faces(const FlattenInput& input, const std::function<bool(const Eigen::Vector3d&)>& keep) {
  std::vector<int> kept;
  std::vector<int> new_index(input.vertices.rows(), -1);
  for (int f = 0; f < input.faces.rows(); ++f) {
    Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
    for (int k = 0; k < 3; ++k) centroid += input.vertices.row(input.faces(f, k)) / 3;
    if (!keep(centroid)) continue;
    kept.push_back(f);
    for (int k = 0; k < 3; ++k) new_index[input.faces(f, k)] = 0;
  }
  int count = 0;
  for (int& index : new_index) {
    if (index == 0) index = count++;
  }
  FlattenInput result;
  result.vertices.resize(count, 3);
  for (int v = 0; v < input.vertices.rows(); ++v) {
    if (new_index[v] >= 0) result.vertices.row(new_index[v]) = input.vertices.row(v);
  }
  result.faces.resize(kept.size(), 3);
  for (int f = 0; f < result.faces.rows(); ++f) {
    for (int k = 0; k < 3; ++k) result.faces(f, k) = new_index[input.faces(kept[f], k)];
  }
  return result;
}

Options by(Method method) {
  Options options;
  options.method = method;
  return options;
}

int position_in(const std::vector<int>& list, int vertex) {
  return static_cast<int>(std::find(list.begin(), list.end(), vertex) - list.begin());
}

int nearest_vertex(const FlattenInput& input, const Eigen::Vector3d& point) {
  Eigen::Index nearest = 0;
  (input.vertices.rowwise() - point.transpose()).rowwise().squaredNorm().minCoeff(&nearest);
  return static_cast<int>(nearest);
}

FlattenInput flat_rectangle(int nx, int ny, double width, double height) {
  return make_grid(nx, ny, [&](double s, double t) { return Eigen::Vector3d(width * s, height * t, 0); });
}

FlattenInput flat_annulus(int around, int across, double inner_radius, double outer_radius) {
  // The grid's t points outwards, so s runs clockwise to make +z the front.
  return make_tube(around, across, [&](double s, double t) {
    const double radius = inner_radius + (outer_radius - inner_radius) * t;
    return Eigen::Vector3d(radius * std::cos(-2 * kPi * s), radius * std::sin(-2 * kPi * s), 0);
  });
}

FlattenInput flat_plate_with_two_holes(int n) {
  return keep_faces(flat_rectangle(3 * n, 2 * n, 3, 2), [](const Eigen::Vector3d& p) {
    const auto in_hole = [&](double x) { return std::abs(p.x() - x) < 0.25 && std::abs(p.y() - 1) < 0.25; };
    return !in_hole(0.75) && !in_hole(2.25);
  });
}

FlattenInput flat_plate_with_wires(int n) {
  FlattenInput plate = flat_plate_with_two_holes(n);
  for (const auto& [from, to] : {std::pair(0.0, 0.5), std::pair(1.0, 2.0), std::pair(2.5, 3.0)}) {
    std::vector<int> wire;
    for (int i = 0; i <= std::lround((to - from) * n); ++i) {
      wire.push_back(nearest_vertex(plate, {from + 1.0 * i / n, 1, 0}));
    }
    add_wire(plate, wire);
  }
  return plate;
}

FlattenInput cylinder_patch(int nx, int ny, double radius, double angle, double height) {
  return make_grid(nx, ny, [&](double s, double t) {
    return Eigen::Vector3d(radius * std::cos(angle * s), radius * std::sin(angle * s), height * t);
  });
}

FlattenInput cone_patch(int nx, int ny, double near, double far, double half_angle, double angle) {
  return make_grid(nx, ny, [&](double s, double t) {
    const double slant = far + (near - far) * t;  // distance from the apex along the side; t runs upwards
    return Eigen::Vector3d(slant * std::sin(half_angle) * std::cos(angle * s),
                           slant * std::sin(half_angle) * std::sin(angle * s), -slant * std::cos(half_angle));
  });
}

FlattenInput cylinder_tube(int nx, int ny, double radius, double height) {
  return make_tube(nx, ny, [&](double s, double t) {
    return Eigen::Vector3d(radius * std::cos(2 * kPi * s), radius * std::sin(2 * kPi * s), height * t);
  });
}

FlattenInput quarter_sphere(int n) {
  FlattenInput input =
      make_grid(n, 2 * n, [](double s, double t) { return on_sphere(kPi / 2 * s, kPi * 75 / 180 * (2 * t - 1)); });
  alternate_diagonals(input, n);
  add_wire(input, grid_column(n, 2 * n, n / 2), 0, "meridian");
  add_wire(input, grid_row(n, n), 0, "equator");
  return input;
}

Surface over_square(const Height& height) {
  return [height](double s, double t) {
    const double x = 2 * s - 1, y = 2 * t - 1;
    return Eigen::Vector3d(x, y, height(x, y));
  };
}

FlattenInput height_field(int n, const Height& height) { return make_grid(n, n, over_square(height)); }

FlattenInput saddle(int n, double bend) {
  return height_field(n, [&](double x, double y) { return bend * (x * x - y * y); });
}

double lopsided_dome(double x, double y) { return -0.4 * (x * x + y * y) - 0.15 * x * y * y; }

FlattenInput bump(int n) {
  return height_field(n, [](double x, double y) { return 0.5 * std::exp(-3 * (x * x + y * y)); });
}

FlattenInput hill(int n) {
  FlattenInput input = height_field(
      n, [](double x, double y) { return 0.5 * std::exp(-3 * ((x - 0.2) * (x - 0.2) + 2 * (y + 0.1) * (y + 0.1))); });
  alternate_diagonals(input, n);
  return input;
}

FlattenInput two_hills(int n, double top) {
  FlattenInput input = make_grid(n, n, [top](double s, double t) {
    const double x = 2 * s - 1, y = 1.5 * (2 * t - 1);
    const double across = std::abs(x) - 0.4, along = y - top;
    return Eigen::Vector3d(x, y, 0.6 * std::exp(-4 * (across * across + along * along)) + 0.1 * y);
  });
  alternate_diagonals(input, n);
  return input;
}

FlattenInput saddle_of_wires(int n, double tolerance) {
  FlattenInput input = saddle(n, 0.5);
  add_wires_on_edges(input, tolerance);
  return input;
}

FlattenInput sphere_band(int nx, int ny, double latitude) {
  return make_tube(nx, ny, [&](double s, double t) { return on_sphere(2 * kPi * s, latitude * (2 * t - 1)); });
}

FlattenInput sphere_of_gores(int gores, int n, int rings, std::optional<double> tolerance) {
  const int nx = gores * n;
  // Adds the rings between the poles first, then the poles and the fans of triangles around them.
  FlattenInput input = make_tube(nx, rings - 2, [&](double s, double t) {
    return on_sphere(2 * kPi * s, kPi * ((1 + t * (rings - 2)) / rings - 0.5));
  });
  const auto south = static_cast<int>(input.vertices.rows());
  const int north = south + 1;
  input.vertices.conservativeResize(south + 2, 3);
  input.vertices.row(south) << 0, 0, -1;
  input.vertices.row(north) << 0, 0, 1;
  auto f = static_cast<int>(input.faces.rows());
  input.faces.conservativeResize(f + 2 * nx, 3);
  const int top = nx * (rings - 2);
  for (int i = 0; i < nx; ++i) {
    const int next = (i + 1) % nx;
    input.faces.row(f++) << south, next, i;
    input.faces.row(f++) << north, top + i, top + next;
  }
  for (int g = 0; g < gores; ++g) {
    std::vector<int> chain = tube_line(nx, rings - 2, g * n);
    chain.insert(chain.begin(), south);
    chain.push_back(north);
    add_seam(input, chain);
    if (tolerance) add_wire(input, chain, *tolerance);
  }
  return input;
}

FlattenInput closed_sphere(int around, int rings) {
  FlattenInput sphere = sphere_of_gores(1, around, rings);
  sphere.seams.resize(0, 2);
  return sphere;
}

FlattenInput closed_torus(int around, int across) {
  FlattenInput torus = make_tube(around, across, [](double s, double t) {
    const double radius = 2 + std::cos(2 * kPi * t);
    return Eigen::Vector3d(radius * std::cos(2 * kPi * s), radius * std::sin(2 * kPi * s), std::sin(2 * kPi * t));
  });
  const int count = around * across;
  torus.faces = torus.faces.unaryExpr([=](int v) { return v % count; }).eval();
  torus.vertices.conservativeResize(count, 3);
  return torus;
}

FlattenInput book(int num_flaps, int n) {
  FlattenInput input;
  const int flap_vertices = n * (n + 1);  // number of a flap's vertices that are not on the spine
  input.vertices.resize(n + 1 + num_flaps * flap_vertices, 3);
  input.faces.resize(num_flaps * 2 * n * n, 3);
  for (int j = 0; j <= n; ++j) input.vertices.row(j) << 0, 0, 1.0 * j / n;
  for (int flap = 0; flap < num_flaps; ++flap) {
    const double angle = 2 * kPi * flap / num_flaps;
    const auto vertex = [&](int i, int j) { return i == 0 ? j : n + 1 + flap * flap_vertices + (i - 1) + n * j; };
    for (int j = 0; j <= n; ++j) {
      for (int i = 1; i <= n; ++i) {
        input.vertices.row(vertex(i, j)) = Eigen::RowVector3d(std::cos(angle) * i, std::sin(angle) * i, j) / n;
      }
    }
    int f = flap * 2 * n * n;
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        input.faces.row(f++) << vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1);
        input.faces.row(f++) << vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1);
      }
    }
  }
  add_seam(input, arithmetic(0, 1, n + 1));
  return input;
}

double misfit(Positions2 a, Positions2 b) {
  a.rowwise() -= a.colwise().mean().eval();
  b.rowwise() -= b.colwise().mean().eval();
  const double c = (a.array() * b.array()).sum();
  const double s = (a.col(0).array() * b.col(1).array() - a.col(1).array() * b.col(0).array()).sum();
  return (a * Eigen::Rotation2Dd(std::atan2(s, c)).toRotationMatrix().transpose() - b).rowwise().norm().maxCoeff();
}

Positions2 planar_positions(const Chart& chart) {
  Positions2 uv(chart.mesh.n_vertices(), 2);
  for (const VertexHandle v : chart.mesh.vertices()) {
    uv.row(v.idx()) << chart.mesh.point(v)[0], chart.mesh.point(v)[1];
  }
  return uv;
}

Charts charts_of(const FlattenInput& input) {
  const EdgeTable edges(input.faces, static_cast<int>(input.vertices.rows()));
  return cut_into_charts(input, edges);
}

Chart chart_of(const FlattenInput& input) { return charts_of(input).charts.at(0); }

}  // namespace wirewarp::test
