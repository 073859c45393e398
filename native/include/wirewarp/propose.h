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

/// A cut with its effect: a dart, a seam across a piece, or a cut set.
///
/// - Cut set: the seams and darts that a piece without a flat shape needs.
/// - Figures: results of flatten() with the edges of the cut as seams. If edges is empty, cut_mesh() makes such edges
///   of paths.
/// - Energy: of all parts together.
/// - Strain: the stretch in reports and verdicts. In 99% of the area of a part, the fabric stretches by at most this
///   value. With a cloth, this is the stretch of the threads. Without a cloth, it is max(sigma_1, 1/sigma_2) - 1,
///   beyond intended eases.
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

/// Returns darts that lower the energy and strain of a piece by at least 2%, to a strain below 1.
///
/// - Darts lead from the outline to a point inside, along smooth chains of edges, and do not cross wires.
/// - Darts are sorted by the strain left in the model, then by the strain removed from their piece.
/// - If a dart helps only together with its mirror image, strain_with_twin is below strain_before.
/// - All lengths stay exact.
/// - Turning, mirroring or renumbering the input changes only the order of equal darts.
///
/// With is_smooth:
///
/// - Darts are lines across triangles without corners, for cut_mesh(). They are straight unless a bend gains clearly
///   more.
/// - The mean strain around the tip is at most 3%, or the strain of the uncut piece if that is larger.
/// - A dart comes with its mirror image if the two darts are better than one of them.
/// - The best dart along edges is added if it leaves at least 5% less strain than all smooth darts.
///
/// Throws:
///
/// - the errors of flatten(), and cancelled if progress returns false
/// - the error of the requested piece if it has no flat shape
/// - no_proposal if the piece is flat already, has no room for a cut, or gains nothing from a cut
std::vector<DartProposal> propose_darts(const FlattenInput& input, const Options& options = {},
                                        const CutOptions& cut_options = {}, const Progress& progress = {});

/// Returns seams that cut a piece from outline to outline. If a piece lacks seams, returns cut sets for it instead.
///
/// The rules of propose_darts() hold for seams. Seams across one piece follow edges, even with is_smooth.
///
/// A piece lacks seams in three cases. If no piece is requested, the largest piece that lacks seams is cut.
///
/// - It is closed, has handles, or has an outline that is too short.
/// - Its flat shape is flipped or overlaps itself.
/// - It has no wires inside, and no shape with its lengths and a strain below 1 was found.
///
/// Cut sets:
///
/// - All parts of a set have a flat shape with a strain below 1.
/// - The first set brings every part to the accepted strain, unless no further cut helps, or 160 cuts follow the first
///   seams. If no strain is given, 40 cuts are enough if the strain is then at most 20%. A cut and its mirror image
///   count as one. If the accepted strain is not reached, the sets are returned with the strain that they leave.
/// - Each later set is shorter and leaves more strain. If there are more than `count`, the first set is listed, and the
///   shortest for each limit: the accepted strain, twice as much and so on.
/// - Sets are symmetric if the piece is symmetric.
/// - Sets may cross wires. They follow neither edges of no_seam nor mirror images of these edges.
/// - A piece joined from two is not narrower than `narrowest`, unless one of the two is equally narrow. The width of a
///   piece is the diameter of the largest disk that can move through it. The disk need not reach parts with less than a
///   tenth of the area.
/// - A piece joined from two covers at least 45% of its convex hull, unless one of the two covers no more of its own.
///
/// Smooth cut sets:
///
/// - Lines turn by less than 30 degrees at each vertex between their ends. They keep bends, or stay on edges, if
///   smoother lines would meet, leave too much strain, or make pieces narrow.
/// - Lines do not cross wires or edges of no_seam and no_crossing.
/// - If a strain is given, cuts along edges go down to half of it, because smoother lines may double it. Otherwise, the
///   first set may leave more than the accepted strain.
/// - A set may leave less strain than an earlier set.
/// - A closed piece is first divided at its necks and along planes through its parts. Such sets have at most 30 pieces.
///   This step needs an input without wires, eases and thickness, and a piece with necks or without long sharp edges.
/// - If no such set has at most 12 pieces, all wide enough and with the accepted strain (default 20%), sets along edges
///   are added.
///
/// If progress returns false, returns the sets found by then. Some may not be smooth yet. Throws the errors of
/// propose_darts(), but cancelled only if no set was found.
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
  /// strain than one of them. They count as two cuts.
  bool twins = false;
  VertexPairs no_seam = VertexPairs(0, 2);  // (k, 2) edges along which no cut may run
};

/// Returns darts to make in this order, until the target or a limit is reached, or no dart helps.
///
/// - Each dart cuts the most strained piece that a dart helps. Of all darts for this piece, it leaves the least strain.
/// - The figures and the piece of a dart refer to the model with all earlier cuts.
/// - Each dart of a mirrored pair has its own figures, and the index of its mirror image.
///
/// Throws the errors of propose_darts() for the first dart, and no_proposal if the target is already met.
std::vector<DartProposal> plan_darts(const FlattenInput& input, const Options& options = {},
                                     const CutTarget& target = {}, const Progress& progress = {});

/// Returns seams and cut sets by the rules of plan_darts(). Pieces that lack seams are cut first, the largest before
/// the others. A cut set has up to 160 cuts: see propose_seams().
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

/// Removes sections of seams that a model does not need, the longest first, and returns the seams that remain.
///
/// - Removing a section joins the pieces beside it. The joined piece must have a flat shape with at most the given
///   strain. The strain that the worst of these pieces has with the input's seams is allowed, too.
/// - After whole sections, parts of sections are tried, divided in the middle and at the sharpest corner.
/// - In a symmetric part of the model between the remaining seams, mirrored sections are removed together.
/// - Strains below 1e-6 are rounding errors and always accepted.
/// - The result does not depend on how the input is turned, mirrored or numbered.
/// - If progress returns false, the result has the seams that remain by then, with their figures.
///
/// These seams remain:
///
/// - seams with an ease on one side, and seams with three sides or more
/// - seams of a part that has no flat shape for other reasons than missing seams, such as a Moebius strip
///
/// Throws:
///
/// - the errors of flatten(), and invalid_option for a strain below 0
/// - cancelled if progress returns false before the pieces of the input are flat
SeamProposal simplify_seams(const FlattenInput& input, const Options& options = {}, double strain = 0.05,
                            const Progress& progress = {});

}  // namespace wirewarp
