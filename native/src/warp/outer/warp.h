// SPDX-License-Identifier: GPL-3.0-or-later
// ψ(h), the flat shape of a chart for given length variations of its wires, and its shape error E with the exact
// gradient with respect to h (paper II-A and II-B). Matrices that do not depend on h are factored once.
#pragma once

#include <optional>
#include <vector>

#include "energy/shape_error.h"
#include "warp/inner/inner_problem.h"
#include "warp/inner/interior_placement.h"
#include "warp/inner/wire_layout.h"

namespace wirewarp {

struct WarpedShape {
  Positions2 uv;            // one row per chart vertex, scene units
  Eigen::VectorXd lengths;  // lengths of the wire edges
  InnerSolution inner;      // uv is empty if inner is not feasible, that is, if no shape with the lengths was found
};

/// All functions throw Stopped and FactorizationFailed.
class Warp {
 public:
  /// chart and network must outlive the warp. Every wire-patch of the network must be a disk (see process_topology).
  /// stop: checked before each step and factorization.
  Warp(const Chart& chart, const WireNetwork& network, NodeWeight node_weight, Inner inner, const StopToken& stop = {});

  /// Returns ψ(h). variation: h > -1, one per wire part of the chart; boundaries without a tolerance keep their length.
  WarpedShape operator()(const Eigen::VectorXd& variation);

  /// Returns ψ(h) on the branch of another shape: the search starts from the angles of that shape, because Eq. (1) may
  /// have several minima.
  WarpedShape follow(const WarpedShape& from, const Eigen::VectorXd& variation);

  /// Returns E of Eq. (4), divided by the chart's 3D area.
  double shape_error(const WarpedShape& shape) const;

  /// Returns the gradient of E with respect to h, one entry per wire part, at a minimum of Eq. (1). Takes one
  /// factorization for any number of wires.
  Eigen::VectorXd gradient(const WarpedShape& shape);

  /// Returns the Gauss-Newton Hessian of E, made positive definite, for the given wire parts, at a minimum of Eq. (1).
  /// Takes one factorization, and four solves for each part.
  Eigen::MatrixXd gauss_newton_hessian(const WarpedShape& shape, const std::vector<int>& parts);

  const StopToken& stop() const { return inner_problem_.stop(); }

  int interior_factorizations() const { return placement_.factorizations(); }
  int inner_factorizations() const { return inner_problem_.num_factorizations(); }  // sum over all calls so far

 private:
  Eigen::VectorXd by_variation(const WarpedShape& shape, Positions2 by_uv) const;
  Eigen::VectorXd lengths_of(const Eigen::VectorXd& variation) const;
  WarpedShape lay_out(InnerSolution inner, Eigen::VectorXd lengths) const;
  const WireNetwork& network_;
  int num_vertices_;
  int num_parts_;
  Inner inner_;
  InnerProblem inner_problem_;
  WireLayout layout_;
  InteriorPlacement placement_;
  ShapeError shape_error_;
  Eigen::VectorXd rest_lengths_;
  double area_;
};

}  // namespace wirewarp
