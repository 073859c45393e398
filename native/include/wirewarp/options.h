// SPDX-License-Identifier: GPL-3.0-or-later
// How to flatten. The comments are what the Python package says of its attributes, too.
#pragma once

#include <array>
#include <optional>

#include "wirewarp/cloth.h"

namespace wirewarp {

/// How wire lengths and the shape are found. The default is the best method there is.
enum class Method {
  wirewarping,         // paper II-A: all wires rigid, planar angles closest to the surface angles (Eq. 1)
  wirewarp_plus_plus,  // paper II-B: the same, with the lengths of elastic wires chosen for the least distortion
  refined,             // beyond the paper: the least distorted shape of all those with such lengths
};

/// Weight of a wire-node in Eq. (1).
enum class NodeWeight {
  length,   // 1 / mean length of the node's two edges: a property of the curve, whatever its vertices
  uniform,  // 1: the paper's; the result depends on where the mesh happens to have vertices
};

/// Which planar angles the inner problem returns.
enum class Inner {
  minimum,     // the local minimiser of Eq. (1) reached from the surface angles
  least_norm,  // the first feasible point of the paper's least-norm steps, all wires rigid; depends on the mesh, for
               // comparison
};

/// Where the pieces lie.
enum class PieceLayout {
  packed,  // near-square
  row,     // side by side from left to right in their order, standing on one line
};

/// What stands upright in each piece.
enum class Orientation {
  wire,      // its wire Options::grain; without wires the longest chain of its outline
  boundary,  // its longest straight stretch of outline, the piece on the left of it
  up,        // Options::up: the direction in which the surface rises most on average; where it is level as by wire
  best,      // of a cloth: the direction in which it has the least energy
};

/// Where in the thickness of the material the surface lies.
enum class Surface {
  inside,   // behind the front faces there is no material: the skin that something worn must fit
  middle,   // the material lies half on either side
  outside,  // the material lies behind the front faces
};

/// How to flatten. A value out of its range is a FlattenError (invalid_option).
struct Options {
  Method method = Method::refined;              // how wire lengths and the shape are found
  NodeWeight node_weight = NodeWeight::length;  // weight of a wire-node in Eq. (1)
  Inner inner = Inner::minimum;                 // which planar angles the inner problem returns

  /// Of the refined method: the shortest wiggle of an outline or wire that is left alone, over the square root of the
  /// piece's area. Larger: smoother lines, more distortion inside. In [0.001, 10].
  double fairness = 0.05;
  static constexpr double least_fairness = 0.001;
  static constexpr double most_fairness = 10;

  /// For the refined method: after so many factorizations of its Newton systems, a piece stops at the shape it has. All
  /// starts and stages count: a coarser mesh, closed slits and elastic seams. A factorization of several pieces coupled
  /// by elastic seams counts for each of them. The stretch of a fabric, which begins where the piece without it ends,
  /// has the same limit once more; so has each of several coupled pieces for itself, if no stretched shapes with common
  /// lengths are found. The search for wires that contradict one another has limits of its own. >= 1.
  int max_factorizations = 200;

  /// Of the refined method: what the pieces are cut from, x along its weft, y along its warp. None: a material that
  /// resists alike in all directions, Eq. (4). The piece is turned as orientation says and then held so; under wire,
  /// boundary and up by the direction between two of its vertices.
  std::optional<Cloth> cloth;

  /// How thick the material is, scene units. Foam and neoprene bend around the middle of their thickness: that is what
  /// is flattened, and all lengths and areas are of it. 0 or above and finite.
  double thickness = 0;

  Surface surface = Surface::inside;  // where in the thickness the given surface lies

  PieceLayout layout = PieceLayout::packed;     // where the pieces lie
  Orientation orientation = Orientation::wire;  // what stands upright in each piece

  /// Of Orientation::wire: index of the input's wire that stands upright in the pieces it runs through. -1, and in the
  /// other pieces: the piece's first wire. In [-1, number of wires).
  int grain = -1;

  /// Of Orientation::wire: how far the chain is turned from +y, counter-clockwise, radians in [-π, π]. With a cloth, y
  /// is its warp: π/4 cuts on the bias.
  double grain_angle = 0;

  /// Of Orientation::up: a direction in space, of any length but 0; finite.
  std::array<double, 3> up = {0, 0, 1};

  /// Space between pieces, as a fraction of the side of a square with the area of all pieces. In [0, 1].
  double gap = 0.03;

  /// Whether the pieces are as seen from inside (from behind the front faces).
  bool mirror = false;
};

/// Throws FlattenError (invalid_option) unless every option is in its range, whatever the number of wires.
void check_options(const Options& options);

}  // namespace wirewarp
