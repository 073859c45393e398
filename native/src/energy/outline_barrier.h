// SPDX-License-Identifier: GPL-3.0-or-later
// A barrier B that prevents the outline of a flat shape from crossing itself. It is infinite if a vertex touches an
// edge.
//
//   B(u) = Σ_c κ w_p d̂_c b(d_c / d̂_c)    over contacts c = (vertex p, edge ab) of the outline, b: log_barrier.h
//
//   κ    constant weight
//   d    distance of p from the nearest point (1 − s) a + s b of the segment from a to b. n is the direction from this
//        point to p, and ∇d is n at p, −(1 − s) n at a, and −s n at b
//   d̂    distance at which the barrier begins: ⅒ of the shortest outline edge that meets p, a or b
//   w_p  half the length of the outline edges at p, so that the sum over p is an integral along the outline
//
// The Gauss-Newton Hessian κ w b″ ∇d ∇dᵀ / d̂ is used. It is positive semidefinite and has all stiff terms.
#pragma once

#include <vector>

#include "energy/vertex_matrix.h"
#include "surface/charts/chart.h"

namespace wirewarp {

class OutlineBarrier {
 public:
  /// layout: the Hessian contains the contacts that are near in this layout.
  OutlineBarrier(const Chart& chart, const Positions2& layout);

  /// Returns B; add_gradient() also adds ∂B/∂u to the gradient. uv, gradient: one row per chart vertex.
  double value(const Positions2& uv) const;
  double add_gradient(const Positions2& uv, Positions2& gradient) const;

  /// Appends the pairs of vertices that the Hessian couples.
  void list_pairs(std::vector<VertexPair>& pairs) const;

  /// Adds the Hessian of the contacts that are near in the layout of the constructor.
  void add_hessian(const Positions2& uv, VertexMatrix& hessian) const;

  /// Returns whether the Hessian contains all contacts of a layout.
  bool covers_contacts(const Positions2& uv) const;

  /// Returns the share of the step d from uv, at most 1, at which the outline first touches itself.
  double longest_step(const Positions2& uv, const Positions2& d) const;

 private:
  struct Edge {
    int a, b;  // chart vertices
    // ⅒ of the shortest outline edge at a or b. The d̂ of a contact is smaller if an edge at its vertex p is shorter.
    double reach;
  };
  struct Contact {
    int p, edge;   // chart vertex, index into edges_
    double reach;  // d̂
  };
  struct Distance {
    double value;
    Eigen::Vector2d normal;  // n
    double along;            // s
  };

  static bool comes_before(const Contact& a, const Contact& b);
  Distance distance(const Positions2& uv, const Contact& contact) const;
  std::vector<Contact> find_contacts(const Positions2& uv, double reaches) const;

  std::vector<Edge> edges_;
  std::vector<int> vertices_;
  std::vector<double> reach_, outline_length_;  // per chart vertex: largest d̂ of its contacts, and w
  std::vector<Contact> covered_;                // contacts in the Hessian, sorted
};

}  // namespace wirewarp
