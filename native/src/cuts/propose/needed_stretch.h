// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "wirewarp/flatten.h"

namespace wirewarp {

/// No fabric stretches to twice its length: what still needs as much is not proposed.
constexpr double kMostStrain = 1;

/// DartProposal::strain: how far the fabric must stretch in a piece, as reports and verdicts have it.
class NeededStretch {
 public:
  /// input: as the user gave it, kept by reference.
  NeededStretch(const FlattenInput& input, bool has_cloth);

  /// Of a piece with a layout.
  double of(const Piece& piece) const;

  /// Of each face of a piece with a layout: what 99% of the area stay below is that of the piece.
  Eigen::VectorXd of_faces(const Piece& piece) const;

 private:
  std::pair<double, double> range_of_eases(const Piece& piece) const;

  const FlattenInput& input_;
  const bool has_cloth_;
  std::vector<double> areas_;           // per face
  std::map<VertexPair, double> sides_;  // eases of directed edges
};

}  // namespace wirewarp
