// SPDX-License-Identifier: GPL-3.0-or-later
// What the refined method minimizes: the shape error of Eq. (4) and the fairness of the wires, and a barrier against
// flips that is silent on ordinary pieces.
//
//   f(u) = E(u) + F(u) + Σ_t A β(det J)                   E: energy/shape_error.h, F: energy/bending.h
//
// Of a cloth, the energy of its threads and their shear instead of E,
//
//   f(u) = Σ_t A φ(J) + Z(u) + F(u) + Σ_t A β(det J)      φ: energy/cloth_law.h, Z: energy/shear_smoothing.h
//
//   β(x) = ω max(0, ⅒ − x)²      finite: what the quick way to the minimum may go through
//   β(x) = κ b(x / ⅒)            infinite where x <= 0, energy/log_barrier.h; to it belongs a step that ends where the
//                                first triangle flips (J. Smith, S. Schaefer, Bijective parameterization with
//                                free boundaries, ACM Transactions on Graphics 34 (2015), article 70)
//
// Hessian of E, with the hat gradients g_i of a triangle as complex numbers and s_i = g_i · i ẑ:
//
//   H_ij = 2A g_i·g_j I − A κ s_i s_jᵀ,   κ = 1/|z|      κ > 1 where the triangle is compressed: there H may be
//   indefinite
//
// The first term is the constant Laplacian; a cloth has none. With det J = |z|² − |w|² the barrier has ∇_i det = g_i z
// − ḡ_i w, and its Hessian without the term that could make it indefinite is A β″ ∇det ∇detᵀ − ½ A β′ M(ḡ_i g_j), M(a +
// ib) the matrix of multiplication by a + ib.
#pragma once

#include <optional>

#include "energy/bending.h"
#include "energy/cloth_law.h"
#include "energy/outline_barrier.h"
#include "energy/refine_task.h"
#include "energy/shape_error.h"
#include "energy/shear_smoothing.h"

namespace wirewarp {

/// How much of the negative curvature of E the Hessian keeps.
enum class Curvature {
  exact,
  convex,  // κ <= 1 everywhere: positive semidefinite
  none,    // κ = 0: the Laplacian
};

/// What no step may lead to.
enum class Injectivity {
  none,    // anything goes, flips at a price
  local,   // no triangle is flipped
  global,  // nor does the outline cross itself: no two points of the piece are in one place
};

class FairShapeError {
 public:
  /// layout: of Injectivity::global, one row per chart vertex; the
  /// Hessian knows the parts of the outline that are near each other there.
  FairShapeError(const RefineTask& task, Injectivity injectivity = Injectivity::none, const Positions2& layout = {});

  /// f, scene units squared; infinite where the injectivity is lost. uv: one row per chart vertex.
  double value(const Positions2& uv) const;
  double value_and_gradient(const Positions2& uv, Positions2& gradient) const;

  /// f of an isometric layout once all coordinates are off by about error: half the trace of the constant Hessian.
  double value_of_rounding(double error) const;

  /// Flipped triangles, and those without area.
  int count_flips(const Positions2& uv) const { return shape_error_.count_flips(uv); }

  /// f is the same for every layout turned: without a cloth.
  bool is_free_to_turn() const { return !cloth_; }

  /// The share of the step d from uv, at most 1, after which the injectivity is first lost.
  double longest_step(const Positions2& uv, const Positions2& d) const;

  /// Whether the Hessian knows all parts of the outline that are near each other.
  bool covers_contacts(const Positions2& uv) const {
    return !outline_barrier_ || outline_barrier_->covers_contacts(uv);
  }

  /// The vertices that the Hessian couples.
  void list_pairs(std::vector<VertexPair>& pairs) const;

  /// Looks up the blocks of a matrix that couples those vertices; add_constant_hessian() and add_curvature() are for it
  /// alone from then on.
  void attach_to(const VertexMatrix& hessian);

  /// Adds what does not depend on positions: twice the cotangent Laplacian, or the Hessian of Z, and that of F.
  void add_constant_hessian(VertexMatrix& hessian) const;

  /// Adds the rest.
  void add_curvature(const Positions2& uv, Curvature curvature, VertexMatrix& hessian) const;

 private:
  struct TriangleBlocks {
    int order[3];                         // corners, by falling vertex index
    VertexMatrix::Block off_diagonal[3];  // (0, 1), (0, 2), (1, 2) in this order
  };

  struct FlipBarrier {
    double value, slope, curvature;  // β, β′, β″
  };

  /// The energy of a cloth and what is against its zigzags.
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
