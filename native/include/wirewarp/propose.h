// SPDX-License-Identifier: GPL-3.0-or-later
// Where to cut a piece that lies flat, but with more distortion than its cloth takes, and one that has no flat shape at
// all, such as a ball.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "wirewarp/flatten.h"

namespace wirewarp {

/// A dart, a seam across a piece or a cut set, and what it does. Each figure is that of flatten() with its edges as
/// seams, and the energy is that of all parts together.
///
/// Strain is the figure of reports and verdicts: without a cloth, what 99% of the area of a part stay below of
/// max(sigma_1, 1/sigma_2) - 1, beyond what eases ask for. With a cloth, the same of the stretch of its threads.
struct DartProposal {
  int piece = -1;                 // the piece that it cuts, as flatten() numbers them without it
  std::vector<VertexPair> edges;  // (k, 2) in order from the outline, to be added to the input's seams; of a cut set
                                  // one line after the other
  double length = 0;              // of its edges on the surface, scene units
  int num_pieces = 0;             // that the piece is divided into: 1 with a dart
  double energy = 0;              // of the piece with the cut: Eq. (4), or of the cloth, over its 3D area
  double energy_before = 0;       // the same without the cut; infinite if there is no flat shape without it
  double strain = 0;              // with the cut: how far the fabric must stretch in the part with most (below)
  double strain_before = 0;       // the same without the cut; infinite if there is no flat shape without it
  std::optional<int> twin;        // index of the proposal that is its mirror image; none if there is none
  std::optional<double> energy_with_twin;  // of the piece with both cuts; none unless that is less, or if they meet
  std::optional<double> strain_with_twin;  // the strain with both cuts
  std::optional<double> strain_left;  // of a plan: most strain of a part that lies flat, after this cut, the one that
                                      // is taken with it and all before; see CutAim::piece
};

/// What to propose.
struct CutWishes {
  std::optional<int> piece;      // to cut, as flatten() numbers them; none: any, whichever gains most
  int count = 5;                 // proposals at most, the mirror images of one another counted once; >= 1
  std::optional<double> strain;  // what may stay: pieces with no more (DartProposal::strain) are left as they are; >=
                                 // 0; none: 0.005, for cut sets 0.05
  double longest = std::numeric_limits<double>::infinity();  // of one cut or set, on the surface, scene units; > 0
  VertexPairs no_seam = VertexPairs(0, 2);                   // (k, 2) edges along which none is to run
};

/// Darts that lower the energy and the strain of a piece by 2% or more, to strain below 1. Those that leave least
/// strain in the model come first, then those that take most strain from their piece. A dart that helps only together
/// with its mirror image has less strain_with_twin. Each runs from the outline to a point inside, along edges that run
/// on smoothly. No wire is cut. All lengths are as exact as without the dart. The same however the input is turned,
/// mirrored or numbered, but for the order of what is equal. Throws what flatten() throws; the error of the piece asked
/// for, if it does not lie flat; no_proposal, where a piece is flat already, has no room or gains by none; cancelled.
std::vector<DartProposal> propose_darts(const FlattenInput& input, const Options& options = {},
                                        const CutWishes& wishes = {}, const Progress& progress = {});

/// Seams that cut a piece from outline to outline, by the same rules.
///
/// Cut sets: if the piece asked for has no flat shape because it lacks seams (closed, with handles, or with an outline
/// that cannot hold it), or if any piece may be cut and some lack seams, for the largest of these. Each proposal is a
/// set of seams and darts under which all parts lie flat. The first one brings every part to the strain that may stay,
/// as far as cuts of the part with most strain help, forty and their mirror images at most; each after it is shorter
/// and leaves more strain. Sets are symmetric if the piece is. They may cross wires, and follow neither edges of
/// no_seam nor their mirror images. Sets that leave a strain of 1 or more are left out.
std::vector<DartProposal> propose_seams(const FlattenInput& input, const Options& options = {},
                                        const CutWishes& wishes = {}, const Progress& progress = {});

/// What cuts that are taken together are to reach.
struct CutAim {
  double strain = 0.05;  // pieces with no more (DartProposal::strain) are left as they are; >= 0
  int most = 2;          // cuts at most; a cut set counts as one; >= 1
  double longest = std::numeric_limits<double>::infinity();       // of one cut or set, on the surface, scene units; > 0
  double total_length = std::numeric_limits<double>::infinity();  // of all cuts together, > 0
  std::optional<int> piece;  // to cut, as flatten() numbers them, and then its parts; none: any
  bool twins = false;  // mirror images are taken together where that is better and allowed: they count as two cuts
  VertexPairs no_seam = VertexPairs(0, 2);  // (k, 2) edges along which none is to run
};

/// Darts one after the other, until the strain is low enough. Each cuts the piece with most strain that a dart helps:
/// of the darts that propose_darts() lists for it, the one that leaves least strain. The figures of each, and the
/// number of its piece, are those beside the cuts before it, of a pair each by itself; twin is the one that is taken
/// with it. Fewer than are allowed mean that the target is met, or that no further one helps. Throws what
/// propose_darts() throws for the first one: no_proposal where the target is met without any.
std::vector<DartProposal> plan_darts(const FlattenInput& input, const Options& options = {}, const CutAim& aim = {},
                                     const Progress& progress = {});

/// Seams and cut sets, by the same rules. Pieces that lack seams come first, the largest of them before the others.
std::vector<DartProposal> plan_seams(const FlattenInput& input, const Options& options = {}, const CutAim& aim = {},
                                     const Progress& progress = {});

}  // namespace wirewarp
