// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces with seams and wires, parametrised by resolution. Faces are counter-clockwise seen from outside (for flat
// and open ones: from +z). Lengths in scene units.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "surface/charts/chart.h"

namespace wirewarp::test {

/// A surface over the unit square; its outside is where ds x dt points.
using Surface = std::function<Eigen::Vector3d(double s, double t)>;

/// nx by ny quads over the unit square, each cut from its lower left to its upper right corner; vertex i + (nx+1) j.
FlattenInput make_grid(int nx, int ny, const Surface& surface);

/// Cuts every second quad of a grid, as on a checkerboard, from its lower right to its upper left corner instead.
void alternate_diagonals(FlattenInput& grid, int nx);

/// An n by n grid whose inner vertices are moved about, by up to this share of an edge, so that nothing is regular and
/// rows and columns are jagged.
FlattenInput jittered_grid(int n, double jitter, const Surface& surface);

/// A mesh of these points and triangles.
FlattenInput mesh_of(const std::vector<std::array<double, 3>>& points, const std::vector<std::array<int, 3>>& faces);

/// A grid closed in s: surface(0, t) = surface(1, t). Vertex i + nx j.
FlattenInput make_tube(int nx, int ny, const Surface& surface);

/// Vertices of row j from left to right, of column i from bottom to top.
std::vector<int> grid_row(int nx, int j);
std::vector<int> grid_column(int nx, int ny, int i);

/// Vertices of the square around vertex (i, j) of a grid, k edges from it, the first repeated.
std::vector<int> grid_square(int nx, int i, int j, int k);

/// Vertices of ring j once around, the first repeated.
std::vector<int> tube_ring(int nx, int j);

/// Vertices of line i of a tube from bottom to top.
std::vector<int> tube_line(int nx, int ny, int i);

/// Marks the edges of a vertex chain as seams.
void add_seam(FlattenInput& input, const std::vector<int>& chain);

void add_wire(FlattenInput& input, const std::vector<int>& chain, double tolerance = 0, const std::string& name = "");

/// Wires along these rows and columns of an n by n grid.
void add_net(FlattenInput& grid, int n, const std::vector<int>& lines, double tolerance = 0);

/// Keeps the faces for which keep(centroid) is true, and the vertices they use, in their order. No seams, no wires.
FlattenInput keep_faces(const FlattenInput& input, const std::function<bool(const Eigen::Vector3d&)>& keep);

/// The vertex nearest to a point.
int nearest_vertex(const FlattenInput& input, const Eigen::Vector3d& point);

// Flat.
FlattenInput flat_rectangle(int nx, int ny, double width, double height);
FlattenInput flat_annulus(int around, int across, double inner_radius, double outer_radius);
/// A 3 by 2 plate with two square holes of side 0.5; n quads to the unit. Holes are whole where n is even.
FlattenInput flat_plate_with_two_holes(int n);

// Developable.
/// A part of a cylinder: angle radians around, height upright.
FlattenInput cylinder_patch(int nx, int ny, double radius, double angle, double height);
/// A part of a cone between two distances from the apex; half_angle between axis and side; angle around the axis.
FlattenInput cone_patch(int nx, int ny, double near, double far, double half_angle, double angle);
/// A whole cylinder, open at both ends.
FlattenInput cylinder_tube(int nx, int ny, double radius, double height);

// Doubly curved.
/// A quarter of the unit sphere from 75 degrees south to 75 degrees north, n by 2n quads with alternating diagonals,
/// and rigid wires along the middle meridian and the equator (the shape of the paper's Fig. 1).
FlattenInput quarter_sphere(int n);
/// z = bend (x² − y²) over the square of side 2.
FlattenInput saddle(int n, double bend);

/// A saddle where every inner edge is a wire of its own: they contradict one another, and all starts fail.
FlattenInput saddle_of_wires(int n, double tolerance);
/// A band of the unit sphere around the equator, up to the given latitude on both sides: two boundary loops.
FlattenInput sphere_band(int nx, int ny, double latitude);
/// The unit sphere cut into equal gores by seams from pole to pole; n quads around each gore, rings upwards.
FlattenInput sphere_of_gores(int gores, int n, int rings);

/// A sphere and a torus without a seam.
FlattenInput closed_sphere(int around, int rings);
FlattenInput closed_torus(int around, int across);

/// num_flaps rectangles that share one edge, a seam with as many sides; n quads along the side of each.
FlattenInput book(int num_flaps, int n);

/// Largest distance between corresponding rows after the rigid motion that fits best.
double misfit(Positions2 a, Positions2 b);

/// The flat coordinates (x, y) of an input that lies in the plane z = 0, per vertex of a chart.
Positions2 planar_positions(const Chart& chart);

/// Charts of an input that has no faults, and the first of them.
Charts charts_of(const FlattenInput& input);
Chart chart_of(const FlattenInput& input);

}  // namespace wirewarp::test
