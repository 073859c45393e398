// SPDX-License-Identifier: GPL-3.0-or-later
// Prints E(ψ(h)) and its exact derivative with respect to the length variation h of one wire part. Does so for each
// part in turn, with h = 0 for all other parts (paper Fig. 3).
//
//   wirewarp_error_curves PIECE LIMIT STEPS < SURFACE
//
// SURFACE contains numbers separated by blanks: the numbers of vertices, faces, seam edges and wires; the coordinates;
// the vertex triples of faces; the vertex pairs of seam edges; and for each wire, its number of vertices and its
// vertices. PIECE is the number of a piece, in the order of flatten(). Prints a line "wire part h E dE/dh" for each of
// STEPS + 1 values of h from -LIMIT to LIMIT and each wire part in the piece. E and its derivative are nan if ψ(h) does
// not exist.
#include <iomanip>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>

#include "surface/charts/cut_into_charts.h"
#include "warp/outer/warp.h"
#include "warp/topology/process_topology.h"

namespace wirewarp {
namespace {

template <typename Array>
void read_rows(std::istream& in, int rows, Array& array) {
  array.resize(rows, Array::ColsAtCompileTime);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < Array::ColsAtCompileTime; ++column) in >> array(row, column);
  }
}

FlattenInput read_surface(std::istream& in) {
  int vertices = 0, faces = 0, seams = 0, wires = 0;
  in >> vertices >> faces >> seams >> wires;
  FlattenInput input;
  read_rows(in, vertices, input.vertices);
  read_rows(in, faces, input.faces);
  read_rows(in, seams, input.seams);
  input.wires.resize(wires);
  for (Wire& wire : input.wires) {
    int length = 0;
    in >> length;
    wire.vertices.resize(length);
    for (int& vertex : wire.vertices) in >> vertex;
  }
  if (!in) throw std::runtime_error("the surface ends too early or contains something other than numbers");
  return input;
}

void print_curve(Warp& warp, const Chart& chart, int part, double limit, int steps) {
  for (int step = 0; step <= steps; ++step) {
    Eigen::VectorXd variation = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(chart.wire_parts.size()));
    variation[part] = limit * (2.0 * step / steps - 1);
    const WarpedShape shape = warp(variation);
    double error = std::numeric_limits<double>::quiet_NaN();
    double slope = error;
    if (shape.inner.is_feasible) {
      error = warp.shape_error(shape);
      slope = warp.gradient(shape)[part];
    }
    std::cout << chart.wire_parts[part].wire_index << ' ' << chart.wire_parts[part].part << ' ' << variation[part]
              << ' ' << error << ' ' << slope << '\n';
  }
}

void print_curves(const FlattenInput& input, int piece, double limit, int steps) {
  const EdgeTable edges(input.faces, static_cast<int>(input.vertices.rows()));
  const Charts charts = cut_into_charts(input, edges);
  const Chart& chart = charts.charts.at(piece);
  if (chart.error) throw *chart.error;
  const std::optional<Chart> refined = process_topology(chart);
  const Chart& prepared = refined ? *refined : chart;
  const WireNetwork network = build_wire_network(prepared);
  Warp warp(prepared, network, NodeWeight::length, Inner::minimum);
  for (int part = 0; part < static_cast<int>(chart.wire_parts.size()); ++part) {
    if (chart.wire_parts[part].kind != WireKind::boundary) print_curve(warp, prepared, part, limit, steps);
  }
}

}  // namespace
}  // namespace wirewarp

int main(int argc, char** argv) {
  if (argc != 4) {
    std::cerr << "usage: wirewarp_error_curves PIECE LIMIT STEPS < SURFACE\n";
    return 2;
  }
  try {
    std::cout << std::setprecision(17);
    wirewarp::print_curves(wirewarp::read_surface(std::cin), std::stoi(argv[1]), std::stod(argv[2]),
                           std::stoi(argv[3]));
  } catch (const std::exception& error) {
    std::cerr << "wirewarp_error_curves: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
