// SPDX-License-Identifier: GPL-3.0-or-later
// A penalty Z on shear that zigzags from triangle to triangle. A thread that is compressed by more than
// shear/(shear + weft) can shorten further by zigzagging, at the cost of a little shear. For a woven fabric, this limit
// is a few percent. Beyond the limit, the energy of a fabric is not convex, and its minima become rougher with every
// refinement of the mesh. Real threads resist zigzags by their bending stiffness. Here, the jumps of the map's
// derivative have a cost:
//
//   Z(u) = ½ (δ √A)² Σ (l/d) |[∂u/∂ν]|²    over the inner edges
//
//   [∂u/∂ν]   jump of the derivative across the edge
//   l         length of the edge
//   d         distance between the centroids of the two triangles at the edge, unfolded
//   A         area of the connected part
//   δ         constant, see shear_smoothing.cpp
//
// Z is the interior penalty of discontinuous Galerkin methods on plates (J. Douglas, T. Dupont, Interior penalty
// procedures, 1976). It is quadratic, does not depend on the refinement, and is zero for an unfolded chart.
#pragma once

#include "energy/quadratic_form.h"
#include "surface/charts/chart.h"

namespace wirewarp {

/// Z with a term for each inner edge. The jump is Σ T_k u_k over the ends of the edge and the two vertices opposite to
/// the edge.
using ShearSmoothing = QuadraticForm<double, 4>;

ShearSmoothing shear_smoothing_of(const Chart& chart);

}  // namespace wirewarp
