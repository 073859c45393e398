// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace wirewarp {

/// How wire lengths and the shape are found. The default is the best method there is.
enum class Method {
  wirewarping,         // paper II-A: all wires rigid, planar angles closest to the surface angles (Eq. 1)
  wirewarp_plus_plus,  // paper II-B: the same, with the lengths of elastic wires chosen for the least distortion
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

struct Options {
  Method method = Method::wirewarp_plus_plus;
  NodeWeight node_weight = NodeWeight::length;
  Inner inner = Inner::minimum;

  /// Space between packed pieces, as a fraction of the side of a square with the area of all pieces. In [0, 1].
  double gap = 0.03;

  /// true: the pieces as seen from inside (from behind the front faces).
  bool mirror = false;
};

}  // namespace wirewarp
