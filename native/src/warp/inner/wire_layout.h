// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/network/wire_network.h"

namespace wirewarp {

/// Places the network's vertices by headings and lengths, along a spanning tree of the wires. The tree prefers short
/// edges, so that the rounding error of a loop is at its longest edge.
class WireLayout {
 public:
  WireLayout(const Chart& chart, const WireNetwork& network);

  /// Writes the rows of the network's vertices to uv (one row per chart vertex, scene units). headings: radians,
  /// lengths: scene units, #wire edges each.
  void place(const Eigen::VectorXd& headings, const Eigen::VectorXd& lengths, Positions2& uv) const;

  /// Applies the derivative of place(): writes the rows of the network's vertices to d_uv.
  void push_forward(const Eigen::VectorXd& headings, const Eigen::VectorXd& lengths, const Eigen::VectorXd& d_headings,
                    const Eigen::VectorXd& d_lengths, Positions2& d_uv) const;

  /// Applies the adjoint of place(): turns ∂E/∂uv at the network's vertices (one row per chart vertex) into ∂E/∂φ and
  /// ∂E/∂l.
  void pull_back(const Eigen::VectorXd& headings, const Eigen::VectorXd& lengths, const Positions2& by_uv,
                 Eigen::VectorXd& by_headings, Eigen::VectorXd& by_lengths) const;

 private:
  struct Step {
    int edge;
    int from;  // chart vertex that is already placed
    int to;
    double sign;  // -1: against half-edge 0 of the edge
  };
  int root_;
  std::vector<Step> steps_;  // from the root outwards
};

}  // namespace wirewarp
