// SPDX-License-Identifier: GPL-3.0-or-later
// ψ(h): the flat shape of a chart for given length variations of its wires, and its shape error E with the exact
// gradient by h (paper II-A and II-B). What does not depend on h is factored once.
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
  Eigen::VectorXd lengths;  // of the wire edges
  InnerSolution inner;      // where the lengths cannot be kept (not feasible), uv is empty
};

/// All throw Stopped, and FactorizationFailed.
class Warp {
 public:
  /// chart and network must outlive the warp. network: every wire-patch a disk (see process_topology).
  /// stop: checked before each step and factorization of Eq. (1).
  Warp(const Chart& chart, const WireNetwork& network, NodeWeight node_weight, Inner inner, const StopToken& stop = {});

  /// ψ(h). variation: h > -1, one per wire part of the chart; boundaries keep their length.
  WarpedShape operator()(const Eigen::VectorXd& variation);

  /// ψ(h) on the branch of another shape, should Eq. (1) have several minima: its angles are reached from that shape's.
  WarpedShape follow(const WarpedShape& from, const Eigen::VectorXd& variation);

  /// E of Eq. (4) over the chart's 3D area.
  double shape_error(const WarpedShape& shape) const;

  /// Its gradient by h at a shape that is a minimum of Eq. (1), one entry per wire part. The adjoint of interior
  /// placement, layout and Eq. (1): one factorization of the inner problem and one transposed solve of the placement,
  /// however many wires there are.
  Eigen::VectorXd gradient(const WarpedShape& shape);

  /// The Gauss-Newton part of its Hessian by h there, for some wire parts: what they stretch and shear, without how
  /// ψ curves. Positive definite: with 1e-4 of the mean curvature on the diagonal. One factorization of the inner
  /// problem; for each part two solves of that and two of the placement.
  Eigen::MatrixXd gauss_newton_hessian(const WarpedShape& shape, const std::vector<int>& parts);

  /// For those who work with the warp.
  const StopToken& stop() const { return inner_problem_.stop(); }

  int interior_factorizations() const { return placement_.factorizations(); }
  int inner_factorizations() const { return inner_problem_.num_factorizations(); }  // of all calls so far

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
