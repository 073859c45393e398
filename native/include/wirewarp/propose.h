// SPDX-License-Identifier: GPL-3.0-or-later
// Where to cut a piece that lies flat, but with more distortion than its cloth takes. Pieces that do not lie flat at
// all carry their seams in FlattenError::elements.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "wirewarp/flatten.h"

namespace wirewarp {

/// A dart, or a seam across a piece, and what it does, each figure from a run of flatten() with its edges as seams.
struct DartProposal {
  int piece = -1;                 // the piece that it cuts, as flatten() numbers them without it
  std::vector<VertexPair> edges;  // (k, 2) in order from the outline, to be added to the input's seams
  double length = 0;              // of its edges on the surface, scene units
  double energy = 0;              // of the piece when cut so: Eq. (4), or of the cloth, over its 3D area
  double energy_before = 0;       // the same without the cut
  double strain = 0;              // when cut so, what 99 % of the area stay below of max(sigma_1, 1/sigma_2) - 1
  double strain_before = 0;       // the same without the cut
  std::optional<int> twin;        // index of the proposal that is its mirror image; none where there is none
  std::optional<double> energy_with_twin;  // of the piece with both cuts; none unless that is less, or if they meet
  std::optional<double> strain_with_twin;  // likewise
};

/// What to propose.
struct CutWishes {
  std::optional<int> piece;  // to cut, as flatten() numbers them; none: any, whichever gains most
  int count = 5;             // proposals at most, the mirror images of one another counted once; >= 1
  double strain = 0.005;     // what may stay: pieces with no more (DartProposal::strain) are left as they are; >= 0
  double longest = std::numeric_limits<double>::infinity();  // of one cut, on the surface, scene units; > 0
  VertexPairs no_seam = VertexPairs(0, 2);                   // (k, 2) edges along which none is to run
};

/// Darts that lower the energy of a piece and do not raise its strain, those that take most from the model first: from
/// the outline to a point inside, along edges that run on smoothly. No wire is cut. All lengths are as exact as without
/// the dart. The same however the input is turned, mirrored or numbered, but for the order of what is equal. Throws
/// what flatten() throws; the error of the piece asked for, if it does not lie flat; no_proposal, where a piece is flat
/// already, has no room or gains by none; cancelled.
std::vector<DartProposal> propose_darts(const FlattenInput& input, const Options& options = {},
                                        const CutWishes& wishes = {}, const Progress& progress = {});

/// Seams that cut a piece from outline to outline, likewise.
std::vector<DartProposal> propose_seams(const FlattenInput& input, const Options& options = {},
                                        const CutWishes& wishes = {}, const Progress& progress = {});

}  // namespace wirewarp
