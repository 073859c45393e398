// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "wirewarp/flatten.h"

namespace wirewarp {

/// Cuts that leave this strain or more are not proposed, because no fabric stretches to twice its length.
constexpr double kMostStrain = 1;

/// Computes DartProposal::strain, the stretch that a piece needs from its fabric, as in reports and verdicts.
class NeededStretch {
 public:
  /// input: as given by the user; must outlive the object.
  NeededStretch(const FlattenInput& input, bool has_cloth);

  /// The piece must have a layout.
  double of(const Piece& piece) const;

  /// Returns the strain of each face of a piece with a flat shape. At most 1% of the area exceeds of(). With a fabric,
  /// this is true for weft and warp separately, so up to 2% may exceed of().
  Eigen::VectorXd of_faces(const Piece& piece) const;

 private:
  std::pair<double, double> range_of_eases(const Piece& piece) const;

  const FlattenInput& input_;
  const bool has_cloth_;
  std::vector<double> areas_;           // per face
  std::map<VertexPair, double> sides_;  // eases of directed edges
};

}  // namespace wirewarp
