// SPDX-License-Identifier: GPL-3.0-or-later
// Suggests where to cut a piece that is too distorted for its fabric, or that has no flat shape, such as a ball, and
// which seams a model can do without.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "wirewarp/flatten.h"
#include "wirewarp/surface_path.h"

namespace wirewarp {

/// A dart, a seam across a piece or a cut set, with its effect. Every figure comes from flatten() with its edges as
/// seams, or with the edges that cut_mesh() makes of its paths, and the energy is that of all parts together.
///
/// Strain is the stretch in reports and verdicts: the value that 99% of the area of a part does not exceed. Without a
/// cloth, it is max(sigma_1, 1/sigma_2) - 1 beyond intended eases. With a cloth, it is the stretch of the threads.
struct DartProposal {
  int piece = -1;                  // index of the piece that it cuts, in the result of flatten() without the cut
  std::vector<VertexPair> edges;   // (k, 2) in order from the outline, to be added to the input's seams; for a cut
                                   // set, one line after the other; empty if a path crosses triangles
  std::vector<SurfacePath> paths;  // the same as lines, for cut_mesh(): one for a dart or seam, one or more for a set
  double length = 0;               // length on the surface, scene units
  int num_pieces = 0;              // number of pieces into which the piece is divided; 1 for a dart
  double energy = 0;               // energy of the piece with the cut: Eq. (4), or cloth energy, divided by its 3D area
  double energy_before = 0;        // energy without the cut; infinite for a cut set
  double strain = 0;               // strain of the worst part with the cut: how far the fabric must stretch
  double strain_before = 0;        // strain without the cut; infinite for a cut set
  std::optional<int> twin;         // index of its mirror image in the list; none if it has no mirror image
  std::optional<double> energy_with_twin;  // energy with both cuts; none if they meet or are no better than one
  std::optional<double> strain_with_twin;  // the strain with both cuts
  std::optional<double> strain_left;  // for a plan: largest strain of a flat part after this cut, its mirror image in
                                      // the same step, and all earlier ones; see CutTarget::piece
};

/// Options of propose_darts() and propose_seams().
struct CutOptions {
  std::optional<int> piece;      // index of the piece to cut in the result of flatten(); none: the one that gains most
  int count = 5;                 // maximum number of proposals, with mirror images counted once; >= 1
  std::optional<double> strain;  // accepted strain: pieces with no more (DartProposal::strain) are ignored; >= 0;
                                 // none: 0.005, for cut sets 0.05
  double longest = std::numeric_limits<double>::infinity();  // length of a cut or set, on the surface, scene units; > 0
  double narrowest = 0;  // least width of the flat pieces of a cut set, scene units; >= 0; 0: any width
  VertexPairs no_seam = VertexPairs(0, 2);      // (k, 2) edges along which no cut may run
  bool is_smooth = false;                       // darts and cut sets may be smooth lines across triangles
  VertexPairs no_crossing = VertexPairs(0, 2);  // (k, 2) edges that no smooth line may cross, and no dart may touch
};

/// Returns darts that lower the energy and the strain of a piece by at least 2%, to a strain below 1. They are sorted
/// by the strain that they leave in the model, then by the strain that they remove from their piece. For a dart that
/// helps only together with its mirror image, strain_with_twin is below the strain before. Darts lead from the outline
/// to a point inside, along smooth chains of edges, and do not cross wires. With is_smooth, they are smooth lines
/// across triangles without corners, straight unless a bend gains clearly more. The best dart along edges is added if
/// it leaves at least 5% less strain than all smooth darts. cut_mesh() turns lines into edges, and the figures are
/// those of flatten() with these edges as seams. Around the tip of a smooth dart, the mean strain is at most 3%, or the
/// strain of the piece without the dart if that is larger. The dart is made with its mirror image if both are better
/// than one. All lengths stay exact. The result does not depend on how the input is turned, mirrored or numbered,
/// except for the order of equal darts. Throws the errors of flatten(), the error of the requested piece if it has no
/// flat shape, no_proposal if a piece is flat already, has no room or gains nothing, and cancelled.
std::vector<DartProposal> propose_darts(const FlattenInput& input, const Options& options = {},
                                        const CutOptions& cut_options = {}, const Progress& progress = {});

/// Returns seams that cut a piece from outline to outline, by the same rules.
///
/// Returns cut sets if the requested piece has no flat shape because it lacks seams: it is closed, has handles, or its
/// outline is too short. A flat shape with a strain of 1 or more and without wires inside does not count. If no piece
/// is requested, the largest such piece is cut. Each proposal is a set of seams and darts with which all parts have a
/// flat shape. The first set brings every part to the accepted strain, if at most forty cuts of the worst part and
/// their mirror images can do so. Each later set is shorter and leaves more strain. Sets are symmetric if the piece is.
/// They may cross wires, but follow neither edges of no_seam nor their mirror images. Sets that leave a strain of 1 or
/// more are not returned.
///
/// The width of a flat piece is the diameter of the largest disk that can move through it, where parts below a tenth of
/// its area do not count. Pieces are not joined if the result would be narrower than `narrowest`, unless one of them is
/// as narrow. Pieces that are narrow from the beginning stay if they cannot be joined to others. Nor are they joined if
/// the result would cover less than 60% of its convex hull, and less of it than each of them covers of its own, because
/// it would have long arms.
///
/// With is_smooth, a closed piece is divided at its necks and along planes through its parts, if the input has no
/// wires, eases and thickness, and if the piece has necks or no long sharp edges. Only sets that keep to no_seam and
/// no_crossing count. The parts are joined for 1, 2 and 4 times the accepted strain, but only up to about 20%, or up to
/// twice a larger accepted strain; without it, for 5%, 10% and 20%. They are not joined for less than 2%. A joined part
/// covers 85% of its convex hull, or as much as one of its parts. Then the lines are smoothed. Sets have at most 30
/// pieces. If one of them keeps the accepted strain, without it 20%, and has at most 12 pieces, all wide enough, no
/// others are searched; otherwise other sets are added. All are sorted by length, the longest first. A shorter set with
/// more pieces may leave less strain.
///
/// Otherwise, with is_smooth, the lines of a cut set are smoothed until they turn by less than 30 degrees at each
/// vertex between their ends, and junctions move with them. Smooth lines do not cross wires, or edges of no_seam and
/// no_crossing. Vertices on these edges do not move. Pieces are joined after their lines were smoothed, for 1, 2, 4, 8,
/// … times the accepted strain, because zigzags along edges work like many small darts. Then the lines are smoothed
/// again within this strain, or within the strain of the set if that is larger. The first set may therefore leave more
/// than the accepted strain. Lines keep some of their bends, or their edges, if they need too much strain otherwise or
/// if lines would meet.
///
/// Sets with few cuts and no joined pieces are smoothed in the end. Such a set leaves at most twice the strain of the
/// set along edges, and stays within the smallest of 1, 2, 4, 8, … times the accepted strain that the set along edges
/// keeps. It has no more pieces narrower than `narrowest` than the set along edges, and keeps all its edges if more
/// than half of its bends would remain. The sets keep the order that they had before, so a smooth set may leave less
/// strain than an earlier one. Seams across one piece always follow edges.
///
/// If progress stops a search for cut sets, the sets found by then are returned, in the same order and with their
/// figures. Some of them may not be smooth yet. Throws cancelled if no set was found by then.
std::vector<DartProposal> propose_seams(const FlattenInput& input, const Options& options = {},
                                        const CutOptions& cut_options = {}, const Progress& progress = {});

/// The target of cuts that are made together.
struct CutTarget {
  double strain = 0.05;  // accepted strain: pieces with no more (DartProposal::strain) are ignored; >= 0
  int most = 2;          // maximum number of cuts; a cut set counts as one; >= 1
  double longest = std::numeric_limits<double>::infinity();  // length of a cut or set, on the surface, scene units; > 0
  double total_length = std::numeric_limits<double>::infinity();  // length of all cuts together; > 0
  std::optional<int> piece;  // index of the only piece to cut, in the result of flatten(); none: any piece
  bool twins = false;        // makes mirror images together if that is better and allowed; they count as two cuts
  VertexPairs no_seam = VertexPairs(0, 2);  // (k, 2) edges along which no cut may run
};

/// Returns darts to make in this order until the strain is low enough. Each dart cuts the worst piece that a dart
/// helps, and is the one from propose_darts() that leaves the least strain. Its figures and the number of its piece
/// refer to the state with the earlier cuts. Each dart of a mirrored pair has its own figures and refers to its mirror
/// image. If there are fewer darts than allowed, the target is met or no further dart helps. Throws the errors of
/// propose_darts() for the first dart, and no_proposal if the target is already met.
std::vector<DartProposal> plan_darts(const FlattenInput& input, const Options& options = {},
                                     const CutTarget& target = {}, const Progress& progress = {});

/// Returns seams and cut sets by the same rules. Pieces that lack seams come first, the largest one before the others.
std::vector<DartProposal> plan_seams(const FlattenInput& input, const Options& options = {},
                                     const CutTarget& target = {}, const Progress& progress = {});

/// Fewer seams for a model, with their effect. Every figure comes from flatten() with these seams, for all pieces
/// together. Strain is defined as in DartProposal.
struct SeamProposal {
  std::vector<VertexPair> edges;   // (k, 2) seams that remain, in place of those of the input; one line after the other
  std::vector<VertexPair> opened;  // (m, 2) seams of the input that are left out
  std::vector<SurfacePath> paths;  // the edges as lines
  double length = 0;               // length of the seams on the surface, scene units
  double length_before = 0;        // length of the input's seams
  int num_pieces = 0;              // number of pieces
  int num_pieces_before = 0;       // number of pieces with the input's seams
  double energy = 0;               // Eq. (4), or cloth energy, divided by the 3D area; infinite if a piece has no flat
                                   // shape
  double energy_before = 0;        // energy with the input's seams
  double strain = 0;               // strain of the worst piece; infinite if a piece has no flat shape
  double strain_before = 0;        // strain with the input's seams
  bool was_stopped = false;        // progress ended the search before every section was tried
};

/// Returns the seams that remain after sections of seams, or parts of them, were removed one by one, the longest first.
/// Sections are divided in the middle and at their sharpest corner. Without a section, the pieces beside it are joined.
/// The section is left out only if flatten() finds a flat shape of the joined piece with at most the given strain, or
/// at most the strain of the worst of these pieces with the input's seams. Strains below 1e-6 are rounding errors and
/// always accepted. If a part between seams that remain is symmetric, mirrored sections in it are left out together.
///
/// Seams with an ease on one side and seams with three sides or more remain. So do all seams of a part of the model
/// that has no flat shape for other reasons than missing seams, such as a Moebius strip. The result does not depend on
/// how the input is turned, mirrored or numbered. If progress returns false, the search ends with the seams that remain
/// by then, and with their figures. Throws the errors of flatten(), invalid_option for a strain below 0, and cancelled
/// before the seams of the input have been flattened.
SeamProposal simplify_seams(const FlattenInput& input, const Options& options = {}, double strain = 0.05,
                            const Progress& progress = {});

}  // namespace wirewarp
