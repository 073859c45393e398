// SPDX-License-Identifier: GPL-3.0-or-later
// The result of a flattening. Indices refer to the input mesh unless a comment says "piece". Lengths are in scene
// units. Flat lengths are NaN for a piece without a layout (flat shape). These comments are also the docstrings of the
// Python package.
#pragma once

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "wirewarp/error.h"
#include "wirewarp/types.h"

namespace wirewarp {

enum class WireKind {
  boundary,       // on a seam or outline
  rigid,          // tolerance 0
  elastic,        // a finite tolerance
  super_elastic,  // free: an infinite tolerance
};

/// Length of a whole wire, or of one part of a wire inside one piece. Parts end at seams and outlines. A part along a
/// dart has a report for each side.
struct WireReport {
  std::string name;                 // the wire's name
  int wire_index = -1;              // index into the input's wires
  int part = -1;                    // index of the part along the wire; -1: the whole wire
  WireKind kind = WireKind::rigid;  // kind of the wire; boundary if it is on a seam or outline
  double tolerance = 0;             // dimensionless, as in the input
  double length_3d = 0;             // on the surface, scene units
  double length_2d = 0;             // in the piece, scene units
  double variation = 0;       // h, the chosen relative change of length: flat lengths are (1+h) times the 3D lengths
  double max_edge_error = 0;  // largest |l2 - (1+r)(1+h) l| / l of its edges; l: length on the surface, l2: length in
                              // the piece, r: ease of the side
  std::vector<int> vertices;  // (n,) in order along the wire; a closed wire repeats its first vertex
};

/// A free wire that the paper's method added to the network of wires (paper III). It crosses the input's faces, and its
/// length is not guaranteed.
struct HelperWire {
  double length_3d = 0;  // on the surface, scene units
  double length_2d = 0;  // in the piece, scene units
  double variation = 0;  // h: the flat length is (1+h) times the 3D length
  Positions3 points_3d;  // (n, 3) on the surface, in order along the wire
  Positions2 points_2d;  // (n, 2) in the piece
};

/// One chain of a piece's outline between junctions, such as a hem, a neckline or one side of a seam.
struct BoundaryReport {
  std::vector<int> vertices;  // (n,) in order, with the piece on the left; a closed chain repeats its first vertex
  double length_3d = 0;       // on the surface, scene units
  double length_2d = 0;       // in the piece, scene units
  double max_edge_error = 0;  // largest |l2 - (1+r)(1+h) l| / l of its edges, as in WireReport
  std::optional<int> seam;    // index into FlattenResult::seams; none if the chain is not a seam
};

/// One chain of seam edges between junctions, with one side for each adjacent face.
struct SeamReport {
  std::vector<int> pieces;        // one per side, ascending; the same piece twice along a dart
  std::vector<VertexPair> edges;  // (k, 2) in order along the chain
  double length_3d = 0;           // on the surface, scene units
  std::vector<double> length_2d;  // one per side, scene units; NaN without a layout
  double variation = 0;  // h, the same for all sides: the mean over the seam if a wire runs along a part of the seam;
                         // NaN if no side has a layout
  std::vector<double> eases;  // r, one per side: relative excess of the side over (1+h) length_3d; NaN without a layout
  double mismatch = 0;  // largest difference, between sides with a layout, of the flat length divided by 1+r, scene
                        // units; NaN for fewer than two such sides
};

/// Distortion of a piece (paper IV-A), on the triangles and edges of the input. Without a layout, all numbers except
/// area_3d are NaN, and the lists of edges and faulty faces are empty.
struct Metrics {
  double arap_energy = 0;             // Eq. (4) divided by the 3D area
  Eigen::VectorXd face_arap;          // (q,) Eq. (6), one per face; sums to arap_energy * area_3d
  Eigen::VectorXd face_aspect_ratio;  // (q,) E_r = max(sigma_1, 1/sigma_2), one per face; 1 on isometries
  /// Energy of Options::cloth divided by the 3D area: NaN without a cloth, infinite if a triangle is flipped.
  double cloth_energy = std::numeric_limits<double>::quiet_NaN();
  Eigen::VectorXd face_weft_strain;       // (q,) strain of threads along x, from flat to worn: 0.1 is 10% longer
  Eigen::VectorXd face_warp_strain;       // (q,) strain of threads along y
  Eigen::VectorXd face_shear_angle;       // (q,) deviation of worn threads from a right angle, radians; positive if the
                                          // angle between x and y becomes smaller
  std::vector<VertexPair> wire_edges;     // (e, 2) the edges of edge_length_variation, wires first, then the boundary
  Eigen::VectorXd edge_length_variation;  // (e,) |l0 - l| / l0 (E_L, Eq. 5) per wire edge; l0: target, l: flat length
  std::vector<int> flipped_faces;         // faces that are flipped in the piece
  std::vector<int> overlapping_faces;     // faces that overlap other faces of the same piece
  double angle_deviation_rms = 0;         // root mean square, over the wire-nodes, of flat minus surface angle, radians
  double angle_deviation_max = 0;         // largest magnitude of flat minus surface angle, radians
  double area_3d = 0;                     // on the surface, square scene units
  double area_2d = 0;                     // in the plane, square scene units
};

enum class Termination {
  converged,  // the method's own criterion is met
  stalled,    // lengths are exact, but the method's criterion is not met: see warnings
  failed,     // no layout: see error
  cancelled,  // the caller canceled before the piece was flat
  measured,   // the piece was measured by measure(), and nothing was solved
};

/// The solver's work on one piece, even if the solver failed.
struct PieceReport {
  Termination termination = Termination::failed;  // how the work ended
  std::string message;                            // text of the error, or that all guarantees hold
  std::vector<std::string> warnings;              // sentences
  std::string start;     // start that led to the shape: "unfolded", "sewn" (slits closed first), "coarse", "free" (ARAP
                         // without wires), "wires" (wires flattened first), "injective" (nothing flipped at any
                         // step). Empty: no shape was found, or the method is not refined
  int inner_solves = 0;  // factorizations of the inner problem (Eq. 1); refined: 0
  int outer_iterations = 0;      // steps over the lengths of wires; refined: steps from the start to the shape
  int gradient_evaluations = 0;  // gradients of the shape error with respect to the lengths of wires

  /// Factorizations of the interior placement and free flattening. Refined: factorizations of the Newton systems of all
  /// starts, as Options::max_factorizations counts them.
  int factorizations = 0;

  /// Largest gap of a wire loop, divided by the loop's length. Refined: largest error of an edge's length, divided by
  /// this length plus 1e-5 √area of the piece. NaN without a shape, and for measure().
  double constraint_residual = std::numeric_limits<double>::quiet_NaN();

  /// Largest entry of the projected gradient at the end, dimensionless. NaN if no gradient was computed.
  ///
  /// - Paper's methods: computed with weight 1 at nodes of mean length. NaN for Inner::least_norm.
  /// - Refined: of the Lagrangian of pieces coupled by elastic seams, divided by √area for vertices and by area for h.
  ///   Pulls of h against its bounds do not count. NaN for a piece that is not coupled.
  double projected_gradient = std::numeric_limits<double>::quiet_NaN();

  /// Refined: arap_energy, or cloth_energy with a cloth, plus the angle term and the barriers against flipped triangles
  /// and zigzag shear. NaN for other methods.
  double objective = std::numeric_limits<double>::quiet_NaN();

  std::map<std::string, double> seconds;  // per stage
};

/// One flat piece: the planar shape of a chart and its measurements.
struct Piece {
  Positions2 vertices;             // (p, 2) scene units; NaN without a layout
  Triangles faces;                 // (q, 3) indices into this piece's vertices
  std::vector<int> source_vertex;  // (p,) input vertex of each vertex; a vertex on a seam can occur several times
  std::vector<int> source_face;    // (q,) input face of each face
  std::vector<WireReport> wires;   // one per part of a wire in this piece
  std::vector<BoundaryReport> boundaries;  // one per chain of its outline between junctions
  std::vector<HelperWire> helper_wires;    // the wires that the method added
  Metrics metrics;                         // distortion
  PieceReport report;                      // the solver's work
  std::optional<FlattenError> error;       // the broken guarantee; none: all guarantees hold
};

/// All pieces of a flattening, and the seams and wires of the whole input.
struct FlattenResult {
  std::vector<Piece> pieces;              // one per region between seams
  CornerUv corner_uv;                     // (m, 3 corners, u and v) in scene units; NaN without a layout
  std::vector<SeamReport> seams;          // one per chain of seam edges between junctions
  std::vector<WireReport> wires;          // whole wires
  std::string method;                     // the method used, or "measure"
  int reused_pieces = 0;                  // number of pieces taken from the cache
  std::map<std::string, double> seconds;  // per stage, summed over pieces that are solved in parallel, and "total"
};

}  // namespace wirewarp
