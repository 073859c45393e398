// SPDX-License-Identifier: GPL-3.0-or-later
// A penalty on shear that zigzags from triangle to triangle. A thread that is compressed by more than shear/(shear +
// weft) can shorten further by zigzagging, at the cost of a little shear. For a woven fabric, this limit is a few
// percent. Beyond the limit, the energy of a fabric is not convex, and its minima become rougher with every refinement
// of the mesh. Real threads resist zigzags by their bending stiffness. Here, the jump of the map's derivative across an
// edge costs
//
//   Z(u) = ½ (δ √A)² Σ (l/d) |[∂u/∂ν]|²    over the inner edges
//
// [∂u/∂ν]: jump of the derivative across the edge. l: length of the edge. d: distance between the centroids of its two
// triangles, unfolded. A: area of the connected part. Z is the interior penalty of discontinuous Galerkin methods on
// plates (J. Douglas, T. Dupont, Interior penalty procedures, 1976): quadratic, independent of refinement, and zero
// where the chart is unfolded.
#pragma once

#include "energy/quadratic_form.h"
#include "surface/charts/chart.h"

namespace wirewarp {

/// Z with a term for each inner edge. The jump is Σ T_k u_k over the ends of the edge and the two vertices opposite to
/// the edge.
using ShearSmoothing = QuadraticForm<double, 4>;

ShearSmoothing shear_smoothing_of(const Chart& chart);

}  // namespace wirewarp
