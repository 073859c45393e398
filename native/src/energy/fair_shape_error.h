// SPDX-License-Identifier: GPL-3.0-or-later
// The objective of the refined method: the shape error of Eq. (4), the fairness of the wires, and a barrier against
// flips that is zero on ordinary pieces.
//
//   f(u) = E(u) + F(u) + Σ_t A β(det J)                   E: energy/shape_error.h, F: energy/bending.h
//
// For a fabric, the energy of its threads and their shear replaces E:
//
//   f(u) = Σ_t A φ(J) + Z(u) + F(u) + Σ_t A β(det J)      φ: energy/cloth_law.h, Z: energy/shear_smoothing.h
//
//   β(x) = ω max(0, ⅒ − x)²      finite: flips are allowed on the way to the minimum
//   β(x) = κ b(x / ⅒)            infinite where x <= 0, energy/log_barrier.h; each step ends before the
//                                first triangle flips (J. Smith, S. Schaefer, Bijective parameterization with
//                                free boundaries, ACM Transactions on Graphics 34 (2015), article 70)
//
// For Injectivity::global, f also contains the barrier B of the outline (energy/outline_barrier.h).
//
// Hessian of E, with the hat gradients g_i of a triangle as complex numbers and s_i = g_i · i ẑ:
//
//   H_ij = 2A g_i·g_j I − A κ s_i s_jᵀ,   κ = 1/|z|
//
// If a triangle is compressed, κ > 1, and its H may be indefinite. The first term is the constant Laplacian. A fabric
// has no such term.
//
// With det J = |z|² − |w|², the gradient of the determinant is ∇_i det = g_i z − ḡ_i w. The Hessian of the barrier is
//
//   H_ij = A β″ ∇_i det ∇_j detᵀ − ½ A β′ M(ḡ_i g_j),   M(a + ib): matrix of the multiplication by a + ib
//
// without a term that may be indefinite. Only Curvature::exact includes this term.
#pragma once

#include <optional>

#include "energy/bending.h"
#include "energy/cloth_law.h"
#include "energy/outline_barrier.h"
#include "energy/shape_error.h"
#include "energy/shear_smoothing.h"

namespace wirewarp {

/// The part of the negative curvature of E that the Hessian includes.
enum class Curvature {
  exact,
  convex,  // κ <= 1, which makes the Hessian positive semidefinite
  none,    // κ = 0, which leaves the Laplacian
};

/// The faults that a step must not cause.
enum class Injectivity {
  none,    // nothing is forbidden; flips are penalized
  local,   // no flipped triangle
  global,  // no flipped triangle, and the outline does not cross itself: the map is injective
};

class FairShapeError {
 public:
  /// cloth: null for the shape error of Eq. (4). layout: for Injectivity::global, one row per chart vertex; the Hessian
  /// includes the contacts of its outline.
  FairShapeError(const Chart& chart, const HeldNetwork& network, double fairness, const Cloth* cloth = nullptr,
                 Injectivity injectivity = Injectivity::none, const Positions2& layout = {});

  /// Returns f in square scene units; infinite if the layout is not injective as required. uv: one row per chart
  /// vertex.
  double value(const Positions2& uv) const;
  double value_and_gradient(const Positions2& uv, Positions2& gradient) const;

  /// Returns f of an isometric layout if all coordinates have errors of about `error`. This is error² times half the
  /// trace of the Hessian.
  double value_of_rounding(double error) const;

  /// Returns the number of flipped triangles and triangles with zero area.
  int count_flips(const Positions2& uv) const { return shape_error_.count_flips(uv); }

  /// Returns the largest share of the step d from uv, at most 1, that keeps the layout injective as required.
  double longest_step(const Positions2& uv, const Positions2& d) const;

  /// Returns whether the Hessian includes all contacts of the outline in a layout.
  bool covers_contacts(const Positions2& uv) const {
    return !outline_barrier_ || outline_barrier_->covers_contacts(uv);
  }

  /// Appends the pairs of vertices that the Hessian couples.
  void list_pairs(std::vector<VertexPair>& pairs) const;

  /// Looks up the blocks of a matrix that couples the pairs of list_pairs(). From then on, add_constant_hessian() and
  /// add_curvature() work with this matrix only.
  void attach_to(const VertexMatrix& hessian);

  /// Adds the part of the Hessian that does not depend on positions: twice the cotangent Laplacian (with a cloth, the
  /// Hessian of Z), and the Hessian of F.
  void add_constant_hessian(VertexMatrix& hessian) const;

  /// Adds the part of the Hessian that depends on positions.
  void add_curvature(const Positions2& uv, Curvature curvature, VertexMatrix& hessian) const;

 private:
  struct TriangleBlocks {
    int order[3];                         // corners by decreasing vertex index
    VertexMatrix::Block off_diagonal[3];  // the pairs (0, 1), (0, 2), (1, 2) of entries of `order`
  };

  struct FlipBarrier {
    double value, slope, curvature;  // β, β′, β″
  };

  struct ClothTerms {
    ClothLaw law;
    ShearSmoothing smoothing;
  };

  double energy(const Positions2& uv) const;
  double energy_and_gradient(const Positions2& uv, Positions2& gradient) const;
  void add_energy_curvature(std::size_t i, const ShapeError::LinearMap& map, Curvature curvature,
                            VertexMatrix& hessian) const;
  FlipBarrier flip_barrier(double determinant) const;
  void add_laplacian(std::size_t i, VertexMatrix& hessian) const;
  template <class BlockOf>
  void add_triangle(std::size_t t, VertexMatrix& hessian, const BlockOf& block_of) const;

  ShapeError shape_error_;
  std::optional<ClothTerms> cloth_;
  Bending bending_;
  Injectivity injectivity_;
  std::optional<OutlineBarrier> outline_barrier_;
  std::vector<TriangleBlocks> blocks_;
};

}  // namespace wirewarp
