// SPDX-License-Identifier: GPL-3.0-or-later
// Suggests where to cut a piece that is too distorted for its fabric, or that has no flat shape, such as a ball. Also
// finds seams that a model does not need.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "wirewarp/flatten.h"
#include "wirewarp/surface_path.h"

namespace wirewarp {

/// A dart, a seam across a piece, or a cut set, with its effect. A cut set consists of the seams and darts that a piece
/// without a flat shape needs. Every figure comes from flatten() with the edges of the cut as seams, or with the edges
/// that cut_mesh() makes of its paths. The energy is that of all parts together.
///
/// Strain is the stretch in reports and verdicts. In 99% of the area of a part, the fabric stretches by at most this
/// value. Without a cloth, the stretch is max(sigma_1, 1/sigma_2) - 1, without the effect of intended eases. With a
/// cloth, it is the stretch of the threads.
struct DartProposal {
  int piece = -1;                  // index of the piece to cut, in the result of flatten() without the cut
  std::vector<VertexPair> edges;   // (k, 2) in order from the outline, to be added to the input's seams; for a cut
                                   // set, one line after the other; empty if a path crosses triangles
  std::vector<SurfacePath> paths;  // the cut as lines for cut_mesh(): one for a dart or seam, one or more for a set
  double length = 0;               // length on the surface, scene units
  int num_pieces = 0;              // number of pieces into which the piece is divided; 1 for a dart
  double energy = 0;               // energy of the piece with the cut: Eq. (4), or cloth energy, divided by its 3D area
  double energy_before = 0;        // energy without the cut; infinite for a cut set
  double strain = 0;               // strain of the worst part with the cut: how far the fabric must stretch
  double strain_before = 0;        // strain without the cut; infinite for a cut set
  std::optional<int> twin;         // index of the mirror image in the list; none if the cut has no mirror image
  std::optional<double> energy_with_twin;  // energy with the cut and its mirror image; none if the two meet, or are
                                           // no better than the cut alone
  std::optional<double> strain_with_twin;  // strain with the cut and its mirror image
  std::optional<double> strain_left;  // in a plan: largest strain, after this step and all earlier steps, of the flat
                                      // parts that may be cut; a step is a cut, or a cut and its mirror image
};

/// Options of propose_darts() and propose_seams().
struct CutOptions {
  std::optional<int> piece;  // index of the piece to cut in the result of flatten(); none: the piece with the best cut
  int count = 5;             // maximum number of proposals, with mirror images counted once; >= 1
  std::optional<double> strain;  // accepted strain (see DartProposal): pieces with at most this strain are ignored;
                                 // >= 0; none: 0.005, or 0.05 for cut sets
  double longest = std::numeric_limits<double>::infinity();  // maximum length of a cut or set, scene units; > 0
  double narrowest = 0;  // least width of the flat pieces of a cut set, scene units; >= 0; 0: any width
  VertexPairs no_seam = VertexPairs(0, 2);      // (k, 2) edges along which no cut may run
  bool is_smooth = false;                       // whether darts and cut sets may be smooth lines across triangles
  VertexPairs no_crossing = VertexPairs(0, 2);  // (k, 2) edges that no smooth line may cross, and that no smooth dart
                                                // may touch
};

/// Returns darts that lower the energy and the strain of a piece by at least 2%, to a strain below 1. Darts are sorted
/// by the strain that they leave in the model, then by the strain that they remove from their piece. If a dart helps
/// only together with its mirror image, strain_with_twin is below strain_before. Darts lead from the outline to a point
/// inside, along smooth chains of edges, and do not cross wires. All lengths stay exact. The result does not depend on
/// how the input is turned, mirrored or numbered, except for the order of equal darts.
///
/// With is_smooth, darts are smooth lines across triangles without corners. They are straight unless a bend gains
/// clearly more. cut_mesh() turns the lines into edges, and the figures are those of flatten() with these edges as
/// seams. Around the tip of a smooth dart, the mean strain is at most 3%, or the strain of the piece without the dart
/// if that is larger. A smooth dart comes with its mirror image if the two darts are better than one of them. The best
/// dart along edges is added if it leaves at least 5% less strain than all smooth darts.
///
/// Throws the errors of flatten(), and cancelled if progress returns false. Throws the error of the requested piece if
/// it has no flat shape. Throws no_proposal if the piece is flat already, has no room for a cut, or gains nothing from
/// a cut.
std::vector<DartProposal> propose_darts(const FlattenInput& input, const Options& options = {},
                                        const CutOptions& cut_options = {}, const Progress& progress = {});

/// Returns seams that cut a piece from outline to outline, by the rules of propose_darts(). Returns cut sets instead if
/// the piece has no flat shape because it lacks seams.
///
/// A piece lacks seams if it is closed, has handles, or has an outline that is too short. A flat shape with a strain of
/// 1 or more counts as no flat shape, unless the piece has wires inside. If no piece is requested, the largest piece
/// that lacks seams is cut. Each proposal is a set of seams and darts with which all parts have a flat shape. The first
/// set brings every part to the accepted strain, unless more than forty cuts with their mirror images would be needed.
/// Each later set is shorter and leaves more strain. Sets are symmetric if the piece is symmetric. They may cross
/// wires, but follow neither edges of no_seam nor mirror images of these edges. Sets that leave a strain of 1 or more
/// are not returned.
///
/// The width of a flat piece is the diameter of the largest disk that can move through it. The disk need not reach
/// parts with less than a tenth of the piece's area. Two pieces are not joined if the joined piece would be narrower
/// than `narrowest`, unless one of the two is equally narrow. Pieces that are narrow from the beginning stay if they
/// cannot be joined to other pieces. Two pieces are not joined either if the joined piece would have long arms. Such a
/// piece covers less than 45% of its convex hull, and a smaller share of its hull than each of the two pieces.
///
/// With is_smooth, a closed piece is first divided at its necks and along planes through its parts. This search needs
/// an input without wires, eases and thickness, and a piece with necks or without long sharp edges. Sets that cross or
/// follow edges of no_seam or no_crossing are left out. Parts are joined again as long as their strain stays within a
/// limit: 1, 2 or 4 times the accepted strain, but at most 20%, or the accepted strain if that is larger. Without an
/// accepted strain, the limits are 5%, 10% and 20%. Limits below 2% are not used. A joined part covers at least 85% of
/// its convex hull, or at least as large a share as one of the parts that it is made of. Then the lines are smoothed.
/// Sets have at most 30 pieces. The search ends if one set has at most 12 pieces, all wide enough, within the accepted
/// strain (20% if none is given). Otherwise, the sets of the next paragraph are added. All sets are sorted by length,
/// the longest first. A shorter set with more pieces may leave less strain.
///
/// With is_smooth, the lines of all other cut sets are smoothed until they turn by less than 30 degrees at each vertex
/// between their ends. Junctions move with the lines. Smooth lines do not cross wires or edges of no_seam and
/// no_crossing, and vertices on these edges do not move. Pieces are joined after their lines were smoothed, because
/// zigzags along edges work like many small darts. For each limit of 1, 2, 4, 8, … times the accepted strain, pieces
/// are joined up to this strain. Then the lines are smoothed again within the limit, or within the strain of the set if
/// that is larger. The first set may therefore leave more than the accepted strain. Lines keep some of their bends, or
/// stay on edges, if smoother lines would need too much strain or would meet.
///
/// Sets with few cuts and no joined pieces are smoothed at the end. A smooth set has at most twice the strain of the
/// set along edges. It also stays within a limit: the accepted strain, doubled until the limit is at least the strain
/// of the set along edges. It has no more pieces narrower than `narrowest` than the set along edges. A set keeps all
/// its edges if more than half of its bends would remain. The sets keep their order, so a smooth set may leave less
/// strain than an earlier set. Seams across one piece always follow edges.
///
/// If progress returns false during a search for cut sets, the sets found by then are returned, in order and with their
/// figures. Some of them may not be smooth yet. Throws cancelled if no set was found by then.
std::vector<DartProposal> propose_seams(const FlattenInput& input, const Options& options = {},
                                        const CutOptions& cut_options = {}, const Progress& progress = {});

/// The target and the limits of plan_darts() and plan_seams().
struct CutTarget {
  double strain = 0.05;  // accepted strain (see DartProposal): pieces with at most this strain are ignored; >= 0
  int most = 2;          // maximum number of cuts; a cut set counts as one; >= 1
  double longest = std::numeric_limits<double>::infinity();       // maximum length of a cut or set, scene units; > 0
  double total_length = std::numeric_limits<double>::infinity();  // maximum total length, scene units; > 0
  std::optional<int> piece;  // index of the only piece to cut, in the result of flatten(); none: any piece
  /// Whether to make a cut together with its mirror image if both cuts are allowed, and if both together leave less
  /// strain than one. They count as two cuts.
  bool twins = false;
  VertexPairs no_seam = VertexPairs(0, 2);  // (k, 2) edges along which no cut may run
};

/// Returns darts to make in this order until the strain is low enough. Each dart cuts the piece with the most strain
/// among the pieces that a dart helps. Of the darts from propose_darts() for this piece, the dart that leaves the least
/// strain is made. Its figures and the number of its piece refer to the model with all earlier cuts. Each dart of a
/// mirrored pair has its own figures and names the index of its mirror image. If there are fewer darts than allowed,
/// the target is met or no further dart helps. Throws the errors of propose_darts() for the first dart, and no_proposal
/// if the target is already met.
std::vector<DartProposal> plan_darts(const FlattenInput& input, const Options& options = {},
                                     const CutTarget& target = {}, const Progress& progress = {});

/// Returns seams and cut sets by the rules of plan_darts(). Pieces that lack seams are cut first, the largest before
/// the others.
std::vector<DartProposal> plan_seams(const FlattenInput& input, const Options& options = {},
                                     const CutTarget& target = {}, const Progress& progress = {});

/// Fewer seams for a model, with their effect. Every figure comes from flatten() with these seams, for all pieces
/// together. Strain is defined as in DartProposal.
struct SeamProposal {
  std::vector<VertexPair> edges;   // (k, 2) seams that replace the seams of the input; one line after the other
  std::vector<VertexPair> opened;  // (m, 2) seams of the input that are left out
  std::vector<SurfacePath> paths;  // the seams of `edges` as lines
  double length = 0;               // length of the seams on the surface, scene units
  double length_before = 0;        // length of the input's seams
  int num_pieces = 0;              // number of pieces
  int num_pieces_before = 0;       // number of pieces with the input's seams
  double energy = 0;               // Eq. (4), or cloth energy, divided by the 3D area; infinite if a piece has no flat
                                   // shape
  double energy_before = 0;        // energy with the input's seams
  double strain = 0;               // strain of the worst piece; infinite if a piece has no flat shape
  double strain_before = 0;        // strain with the input's seams
  bool was_stopped = false;        // whether progress ended the search before every section was tried
};

/// Removes sections of seams one by one, the longest first, and returns the seams that remain. If no whole section can
/// be removed, tries parts of sections, divided in the middle and at the sharpest corner. Removing a section joins the
/// pieces beside it. A section is removed only if flatten() finds a flat shape of the joined piece with at most the
/// given strain, or with at most the strain that the worst of the pieces beside the section has with the input's seams.
/// Strains below 1e-6 are rounding errors and always accepted. If a part of the model between the remaining seams is
/// symmetric, mirrored sections in this part are removed together.
///
/// Seams with an ease on one side and seams with three sides or more remain. So do all seams of a part of the model
/// that has no flat shape for other reasons than missing seams, such as a Moebius strip. The result does not depend on
/// how the input is turned, mirrored or numbered. If progress returns false, the search ends with the seams that remain
/// by then, and with their figures. Throws cancelled if progress returns false before the pieces of the input have been
/// flattened. Throws the errors of flatten(), and invalid_option for a strain below 0.
SeamProposal simplify_seams(const FlattenInput& input, const Options& options = {}, double strain = 0.05,
                            const Progress& progress = {});

}  // namespace wirewarp
