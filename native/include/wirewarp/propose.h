// SPDX-License-Identifier: GPL-3.0-or-later
// Where to cut a piece that lies flat, but with more distortion than its cloth takes, and one that has no flat shape at
// all, such as a ball.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "wirewarp/flatten.h"

namespace wirewarp {

/// A dart, a seam across a piece or a set of first cuts, and what it does, each figure from a run of flatten() with its
/// edges as seams. Of a set of first cuts the energy is that of all its pieces, the strain that of the piece with most.
struct DartProposal {
  int piece = -1;                 // the piece that it cuts, as flatten() numbers them without it
  std::vector<VertexPair> edges;  // (k, 2) in order from the outline, to be added to the input's seams; of a set one
                                  // line after the other
  double length = 0;              // of its edges on the surface, scene units
  double energy = 0;              // of the piece when cut so: Eq. (4), or of the cloth, over its 3D area
  double energy_before = 0;       // the same without the cut; infinite where there is no flat shape without
  double strain = 0;              // when cut so, what 99 % of the area stay below of max(sigma_1, 1/sigma_2) - 1
  double strain_before = 0;       // the same without the cut; infinite likewise
  std::optional<int> twin;        // index of the proposal that is its mirror image; none where there is none
  std::optional<double> energy_with_twin;  // of the piece with both cuts; none unless that is less, or if they meet
  std::optional<double> strain_with_twin;  // likewise
  std::optional<double> strain_left;  // of a plan: what the part with most strain, of those that lie flat, has when
                                      // it, what is taken with it and all before are cut; see CutAim::piece
};

/// What to propose.
struct CutWishes {
  std::optional<int> piece;      // to cut, as flatten() numbers them; none: any, whichever gains most
  int count = 5;                 // proposals at most, the mirror images of one another counted once; >= 1
  std::optional<double> strain;  // what may stay: pieces with no more (DartProposal::strain) are left as they are; >=
                                 // 0; none: 0.005, and 0.05 of what first cuts leave
  double longest = std::numeric_limits<double>::infinity();  // of one cut or set, on the surface, scene units; > 0
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
///
/// First cuts, where the piece asked for has no flat shape for want of seams (closed, with handles, or with an outline
/// that cannot hold it), of all pieces the largest such one: each proposal is a set of seams and darts under which all
/// parts lie flat. The first one has as many cuts as bring every part to the strain that may stay, as far as further
/// ones of the part strained most help, forty and their mirror images at most; each after it is the same without some
/// of the last. Sets are symmetric where the piece is. They may cross wires, and run neither along edges of no_seam nor
/// along the mirror images of these.
std::vector<DartProposal> propose_seams(const FlattenInput& input, const Options& options = {},
                                        const CutWishes& wishes = {}, const Progress& progress = {});

/// What cuts that are taken together are to reach.
struct CutAim {
  double strain = 0.05;  // pieces with no more (DartProposal::strain) are left as they are; >= 0
  int most = 2;          // cuts at most; a set of first cuts counts as one; >= 1
  double longest = std::numeric_limits<double>::infinity();       // of one cut or set, on the surface, scene units; > 0
  double total_length = std::numeric_limits<double>::infinity();  // of all together, likewise
  std::optional<int> piece;  // to cut, as flatten() numbers them, and then its parts; none: any
  bool twins = false;  // mirror images are taken together where that is better and allowed: they count as two cuts
  VertexPairs no_seam = VertexPairs(0, 2);  // (k, 2) edges along which none is to run
};

/// Darts one after the other, until the strain is low enough. Each cuts the piece with most strain that a dart helps:
/// of the darts that propose_darts() lists for it, the one that leaves least strain. The figures of each, and the
/// number of its piece, are those beside the cuts before it, of a pair each by itself; twin is the one that is taken
/// with it. Fewer than are allowed mean that the aim is met, or that no further one helps. Throws what propose_darts()
/// throws for the first one: no_proposal where the aim is met without any.
std::vector<DartProposal> plan_darts(const FlattenInput& input, const Options& options = {}, const CutAim& aim = {},
                                     const Progress& progress = {});

/// Seams and sets of first cuts, likewise. Pieces that lack seams come first, the largest of them before the others.
std::vector<DartProposal> plan_seams(const FlattenInput& input, const Options& options = {}, const CutAim& aim = {},
                                     const Progress& progress = {});

}  // namespace wirewarp
