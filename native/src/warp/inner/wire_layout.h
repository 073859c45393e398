// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/network/wire_network.h"

namespace wirewarp {

/// Positions of the network's vertices from headings and lengths: walks a spanning tree of the wires. The tree takes
/// the shortest edges first, so that what rounding leaves of a loop's gap falls on the longest edge of the loop.
class WireLayout {
 public:
  WireLayout(const Chart& chart, const WireNetwork& network);

  /// Writes the rows of the network's vertices into uv (one row per chart vertex, scene units).
  /// headings: radians, lengths: scene units, #wire edges.
  void place(const Eigen::VectorXd& headings, const Eigen::VectorXd& lengths, Positions2& uv) const;

  /// The derivative of place(): writes the rows of the network's vertices into d_uv.
  void push_forward(const Eigen::VectorXd& headings, const Eigen::VectorXd& lengths, const Eigen::VectorXd& d_headings,
                    const Eigen::VectorXd& d_lengths, Positions2& d_uv) const;

  /// The adjoint of place(): from ∂E/∂uv at the network's vertices (one row per chart vertex) to ∂E/∂φ and ∂E/∂l.
  void pull_back(const Eigen::VectorXd& headings, const Eigen::VectorXd& lengths, const Positions2& by_uv,
                 Eigen::VectorXd& by_headings, Eigen::VectorXd& by_lengths) const;

 private:
  struct Step {
    int edge;
    int from;  // chart vertex that is placed already
    int to;
    double sign;  // -1: against the edge's half-edge 0
  };
  int root_;
  std::vector<Step> steps_;  // from the root outwards
};

}  // namespace wirewarp
