// SPDX-License-Identifier: GPL-3.0-or-later
// The options of flatten(). These comments are also the docstrings of the Python package.
#pragma once

#include <array>
#include <optional>

#include "wirewarp/cloth.h"

namespace wirewarp {

/// How wire lengths and the shape are found. Use the default unless you compare with the paper.
enum class Method {
  wirewarping,         // paper II-A: all wires rigid, planar angles closest to the surface angles (Eq. 1)
  wirewarp_plus_plus,  // paper II-B: as wirewarping, but elastic wires get the lengths with the least distortion
  refined,             // not in the paper: the least distorted shape with the requested lengths
};

/// Weight of a wire-node in Eq. (1).
enum class NodeWeight {
  length,   // 1 / mean length of the node's two edges: independent of how finely the curve is divided
  uniform,  // 1, as in the paper; the result depends on where the mesh has vertices
};

/// Planar angles that the inner problem, Eq. (1), returns.
enum class Inner {
  minimum,     // the local minimizer of Eq. (1) reached from the surface angles
  least_norm,  // for comparison: the first feasible point of the paper's least-norm steps, with all wires rigid; the
               // result depends on the mesh
};

/// How the pieces are placed.
enum class PieceLayout {
  packed,  // packed into about a square
  row,     // side by side on one line, from left to right in the order of the pieces
};

/// Direction that is up in each piece.
enum class Orientation {
  wire,      // the wire Options::grain or else the piece's first wire; without wires, the longest chain of the outline
  boundary,  // the longest straight section of the outline, with the piece on its left
  up,        // the direction in which the surface rises most toward Options::up; for level pieces, as for wire
  best,      // the direction with the least energy of the cloth; needs a cloth
  grain,     // as for wire in pieces that the wire Options::grain crosses, as for up in other pieces
};

/// Surface of a thick material that the input represents.
enum class Surface {
  inside,   // the inner surface, like a body's: the material is on the side of the normals
  middle,   // the middle surface: half of the material is on each side
  outside,  // the outer surface: the material is on the side away from the normals
};

/// How to flatten. A value out of its range throws FlattenError (invalid_option).
struct Options {
  Method method = Method::refined;              // how wire lengths and the shape are found
  NodeWeight node_weight = NodeWeight::length;  // weight of a wire-node in Eq. (1)
  Inner inner = Inner::minimum;                 // planar angles that the inner problem returns

  /// For the refined method: shortest wavelength that is not smoothed in outlines and wires, divided by the square root
  /// of the piece's area. Larger values give smoother lines and more distortion inside. In [0.001, 10]. With 0.001, the
  /// wavelength is shorter than the edges of a piece with a million equal triangles. With 10, it is ten times the
  /// piece's size.
  double fairness = 0.05;
  static constexpr double least_fairness = 0.001;
  static constexpr double most_fairness = 10;

  /// For the refined method: maximum number of Newton factorizations for a piece, >= 1. A piece that reaches this
  /// number keeps its current shape. With 100, cases 378 and 1627 of tests/random_cases fail.
  ///
  /// - All starts and stages count: a coarser mesh, closed slits and elastic seams.
  /// - A factorization of pieces coupled by elastic seams counts for each of these pieces.
  /// - The search for contradicting wires has its own limits.
  ///
  /// For a fabric that is stretched when worn, pieces are solved without the stretch first. The count starts again:
  ///
  /// - for the solution with the stretch
  /// - for each coupled piece alone, if no stretched shapes with common lengths are found
  /// - for each piece that is flipped or overlaps itself in its solution without the stretch
  int max_factorizations = 200;

  /// For the refined method: the fabric, with x along its weft and y along its warp; none: isotropic, Eq. (4). Pieces
  /// keep the direction of Options::orientation while they are solved, except for Orientation::best.
  std::optional<Cloth> cloth;

  /// Thickness of the material in scene units, finite and at least 0. The middle surface is flattened, because bent
  /// material keeps its length there. All lengths and areas refer to it.
  double thickness = 0;

  Surface surface = Surface::inside;  // surface of the thick material that the input represents

  PieceLayout layout = PieceLayout::packed;     // how the pieces are placed
  Orientation orientation = Orientation::wire;  // direction that is up in each piece

  /// For Orientation::wire and grain: index of the wire that is upright in pieces that it crosses; -1: no wire. In
  /// [-1, number of wires). In other pieces, Orientation::wire uses the piece's first wire.
  int grain = -1;

  /// Angle of the chain that Orientation::wire or grain uses, from +y, counterclockwise, in radians, in [-π, π]. With a
  /// cloth, y is its warp, so π/4 cuts on the bias.
  double grain_angle = 0;

  /// For Orientation::up and grain: a direction in space, finite and not zero.
  std::array<double, 3> up = {0, 0, 1};

  /// Space between pieces, as a fraction of the side of a square with the area of all pieces. In [0, 1].
  double gap = 0.03;

  /// Whether the pieces are seen from inside, that is, from behind the front faces.
  bool mirror = false;
};

/// Throws FlattenError (invalid_option) unless every option is in its range. Does not check the number of wires.
void check_options(const Options& options);

}  // namespace wirewarp
