// SPDX-License-Identifier: GPL-3.0-or-later
// Makes surfaces with seams and wires, at any resolution. Faces are counter-clockwise seen from outside, or from +z for
// flat and open surfaces. Lengths are in scene units.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "surface/charts/chart.h"

namespace wirewarp::test {

/// A surface over the unit square. The direction ds × dt points outside.
using Surface = std::function<Eigen::Vector3d(double s, double t)>;

/// Returns the default options with this method.
Options by(Method method);

/// Returns a grid of nx by ny quads over the unit square. The diagonal from lower left to upper right divides each
/// quad. The vertex in column i and row j is i + (nx + 1) j.
FlattenInput make_grid(int nx, int ny, const Surface& surface);

/// Turns the diagonal of every second quad of a grid, as on a checkerboard.
void alternate_diagonals(FlattenInput& grid, int nx);

/// Returns an n by n grid with jagged rows and columns. Vertices are moved at random by up to `jitter` times the length
/// of an edge, and outline vertices only along the outline.
FlattenInput jittered_grid(int n, double jitter, const Surface& surface);

FlattenInput mesh_of(const std::vector<std::array<double, 3>>& points, const std::vector<std::array<int, 3>>& faces);

/// Returns a grid that is closed in s. surface(0, t) must equal surface(1, t). The vertex in column i and row j is
/// i + nx j.
FlattenInput make_tube(int nx, int ny, const Surface& surface);

/// Returns the vertices chain[first] to chain[last].
std::vector<int> section(const std::vector<int>& chain, int first, int last);

/// Return the vertices of row j from left to right, and of column i from bottom to top.
std::vector<int> grid_row(int nx, int j);
std::vector<int> grid_column(int nx, int ny, int i);

/// Returns the vertices of the square around vertex (i, j) of a grid at a distance of k edges. The first vertex is
/// repeated at the end.
std::vector<int> grid_square(int nx, int i, int j, int k);

/// Return the vertices of a tube: those of ring j, with the first vertex repeated at the end, or those of line i from
/// bottom to top.
std::vector<int> tube_ring(int nx, int j);
std::vector<int> tube_line(int nx, int ny, int i);

void add_seam(FlattenInput& input, const std::vector<int>& chain);
void add_wire(FlattenInput& input, const std::vector<int>& chain, double tolerance = 0, const std::string& name = "");

/// Adds wires along the rows and the columns with these indices, in an n by n grid.
void add_net(FlattenInput& grid, int n, const std::vector<int>& lines, double tolerance = 0);

/// Adds a wire on each inner edge whose middle is in a region, by default everywhere.
void add_wires_on_edges(FlattenInput& input, double tolerance = 0,
                        const std::function<bool(const Eigen::Vector3d& middle)>& is_in_region = {});

/// Returns a mesh of the faces for which keep(centroid) is true. Faces and their vertices keep their order. Seams and
/// wires are dropped.
FlattenInput keep_faces(const FlattenInput& input, const std::function<bool(const Eigen::Vector3d&)>& keep);

/// Returns the position of a vertex in a list such as Piece::source_vertex.
int position_in(const std::vector<int>& list, int vertex);

int nearest_vertex(const FlattenInput& input, const Eigen::Vector3d& point);

FlattenInput flat_rectangle(int nx, int ny, double width, double height);
FlattenInput flat_annulus(int around, int across, double inner_radius, double outer_radius);
/// A plate of 3 by 2 with two square holes of side 0.5. It has n quads per unit. n must be even, so that the holes are
/// square.
FlattenInput flat_plate_with_two_holes(int n);
/// The plate with two holes and three rigid wires along y = 1. They connect the outline and both holes from left to
/// right.
FlattenInput flat_plate_with_wires(int n);

/// A part of a cylinder with an upright axis. angle: radians around the axis.
FlattenInput cylinder_patch(int nx, int ny, double radius, double angle, double height);
/// A part of a cone between two distances from the apex. half_angle: radians between axis and side. angle: radians
/// around the axis.
FlattenInput cone_patch(int nx, int ny, double near, double far, double half_angle, double angle);
/// A whole cylinder, open at both ends.
FlattenInput cylinder_tube(int nx, int ny, double radius, double height);

/// The shape of the paper's Fig. 1: a quarter of the unit sphere between the latitudes of -75 and 75 degrees. It has n
/// by 2n quads, and rigid wires along the middle meridian and the equator.
FlattenInput quarter_sphere(int n);
/// z = bend (x² − y²) over the square of side 2.
FlattenInput saddle(int n, double bend);
/// A saddle with a separate wire on every inner edge. If the tolerance is small, the wires contradict one another, so
/// no start of the solver succeeds.
FlattenInput saddle_of_wires(int n, double tolerance);
/// A band of the unit sphere around the equator, from -latitude to latitude in radians. The band has two boundary
/// loops.
FlattenInput sphere_band(int nx, int ny, double latitude);
/// The unit sphere cut into equal gores by seams from pole to pole. Each gore has n quads across, and `rings` rows of
/// faces. If a tolerance is given, each seam is also a wire.
FlattenInput sphere_of_gores(int gores, int n, int rings, std::optional<double> tolerance = std::nullopt);

/// A function that returns the height z over the point (x, y). over_square() returns its surface over the square from
/// -1 to 1.
using Height = std::function<double(double x, double y)>;
Surface over_square(const Height& height);
/// A surface of heights over the square from -1 to 1, as an n by n grid.
FlattenInput height_field(int n, const Height& height);
double lopsided_dome(double x, double y);
FlattenInput bump(int n);
/// A hill off the middle of a sheet, without symmetry. The diagonals alternate.
FlattenInput hill(int n);
/// A sheet of 2 by 3 with two hills, which are mirror images across x = 0. top: y of the tops of the hills.
FlattenInput two_hills(int n, double top = 0);

FlattenInput closed_sphere(int around, int rings);
FlattenInput closed_torus(int around, int across);

/// num_flaps rectangles with one common edge. The edge is a seam with num_flaps sides. Each rectangle has n quads along
/// its side.
FlattenInput book(int num_flaps, int n);

/// Returns the largest distance between corresponding rows of a and b, after the rigid motion that fits a to b best.
double misfit(Positions2 a, Positions2 b);

/// Returns the coordinates (x, y) of each vertex of a chart in the plane z = 0.
Positions2 planar_positions(const Chart& chart);

Charts charts_of(const FlattenInput& input);
Chart chart_of(const FlattenInput& input);

}  // namespace wirewarp::test
