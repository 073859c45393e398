// SPDX-License-Identifier: GPL-3.0-or-later
// What a flattening returns. Indices are of the input mesh unless a comment says "piece". Lengths in scene units, NaN
// where there is no layout. The comments are what the Python package says of its attributes, too.
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
  boundary,       // on a seam or outline, which keep their lengths
  rigid,          // tolerance 0
  elastic,        // a finite tolerance
  super_elastic,  // free: an infinite tolerance
};

/// Length of one part of a wire inside one piece (parts end at seams and boundaries), or of a whole wire. A part along
/// a dart has one for each side.
struct WireReport {
  std::string name;                 // the wire's name
  int wire_index = -1;              // index into the input's wires
  int part = -1;                    // counted along the wire; -1: the whole wire
  WireKind kind = WireKind::rigid;  // of the wire, or that it lies on the boundary
  double tolerance = 0;             // dimensionless, as the user wrote it
  double length_3d = 0;             // on the surface, scene units
  double length_2d = 0;             // in the piece, scene units
  double variation = 0;             // h, the length variation the method chose: lengths are (1+h) times the 3D ones
  double max_edge_error = 0;        // largest |l2 - (1+r)(1+h) l| / l of its edges, r the ease of their side
  std::vector<int> vertices;        // (n,) in order along the wire; a closed one repeats its first
};

/// A super-elastic wire that the method added where the network of wires needs one (paper III). It runs across the
/// input's faces, and promises nothing.
struct HelperWire {
  double length_3d = 0;  // on the surface, scene units
  double length_2d = 0;  // in the piece, scene units
  double variation = 0;  // h: its flat length is (1+h) times the 3D one
  Positions3 points_3d;  // (n, 3) on the surface, in order along the wire
  Positions2 points_2d;  // (n, 2) in the piece
};

/// One chain of the outline of a piece between junctions: hem, neckline, armhole, one side of a seam.
struct BoundaryReport {
  std::vector<int> vertices;  // (n,) in order along the outline, the piece on the left; a closed one repeats its first
  double length_3d = 0;       // on the surface, scene units
  double length_2d = 0;       // in the piece, scene units
  double max_edge_error = 0;  // largest |l2 - (1+r)(1+h) l| / l of its edges
  std::optional<int> seam;    // index into FlattenResult::seams; none where it is no seam
};

/// One chain of seam edges between junctions, with a side for each face that meets it.
struct SeamReport {
  std::vector<int> pieces;        // one per side, ascending; the same piece twice along a dart
  std::vector<VertexPair> edges;  // (k, 2) in order along the chain
  double length_3d = 0;           // on the surface, scene units
  std::vector<double> length_2d;  // one per side, scene units; NaN where the piece has no layout
  double variation = 0;           // h, one for all sides: the mean where a wire runs along a part of it; NaN if no side
                                  // has a layout
  std::vector<double> eases;  // r, one per side: by how much it is longer than (1+h) length_3d; NaN without a layout
  double mismatch = 0;  // largest difference of l2 / (1+r) between sides with a layout; NaN if fewer than two have one
};

/// Distortion of a piece (paper IV-A), on the input's own triangles and edges. Without a layout only area_3d is known:
/// the other numbers are NaN, one per face in what is of faces, and the lists are empty.
struct Metrics {
  double arap_energy = 0;             // Eq. (4) divided by the 3D area
  Eigen::VectorXd face_arap;          // (q,) Eq. (6), one per face; sums to arap_energy * area_3d
  Eigen::VectorXd face_aspect_ratio;  // (q,) E_r = max(sigma_1, 1/sigma_2), one per face; 1 on isometries
  /// Of Options::cloth over the 3D area: NaN without one, infinite where a triangle is turned over.
  double cloth_energy = std::numeric_limits<double>::quiet_NaN();
  Eigen::VectorXd face_weft_strain;       // (q,) of threads along x, from flat to worn: 0.1 is 10 % longer
  Eigen::VectorXd face_warp_strain;       // (q,) the same along y
  Eigen::VectorXd face_shear_angle;       // (q,) how far worn threads leave the right angle, radians; positive where x
                                          // and y come nearer
  std::vector<VertexPair> wire_edges;     // (e, 2) the edges of edge_length_variation, wires first, then the boundary
  Eigen::VectorXd edge_length_variation;  // (e,) E_L (Eq. 5) = |l0 - l| / l0, one per wire edge
  std::vector<int> flipped_faces;         // faces that are turned over
  std::vector<int> overlapping_faces;     // faces that cover a part of the piece a second time
  double angle_deviation_rms = 0;         // of theta - alpha over the wire-nodes, radians
  double angle_deviation_max = 0;         // of the same, radians
  double area_3d = 0;                     // on the surface, square scene units
  double area_2d = 0;                     // in the plane, square scene units
};

enum class Termination {
  converged,  // the method's own criterion is met
  stalled,    // exact lengths, but short of the method's criterion: see warnings
  failed,     // no layout: see error
  cancelled,  // before it was flat
  measured,   // by measure(): nothing was solved
};

/// What the solver did for one piece. For a piece that failed too.
struct PieceReport {
  Termination termination = Termination::failed;  // how it ended
  std::string message;                            // one sentence
  std::vector<std::string> warnings;              // sentences
  std::string start;     // refined: where the shape began: "unfolded", "sewn" (slits sewn up first), "coarse", "free"
                         // (ARAP without wires), "wires" (flattened alone first), "injective" (nothing flipped on the
                         // way). Empty: no shape was found, or another method
  int inner_solves = 0;  // factorizations of the inner problem (Eq. 1); refined: 0
  int outer_iterations = 0;      // steps over the lengths of wires; refined: steps of the start that led to the shape
  int gradient_evaluations = 0;  // gradients of the shape error by these lengths

  /// Of the interior placement and free flattening; refined: of Newton systems for all starts, those of a coarser mesh
  /// or of the piece with slits sewn up among them, as Options::max_factorizations counts them.
  int factorizations = 0;

  /// Largest gap of a wire loop / its length; refined: largest error of an edge's length / (its length + 1e-5 of the
  /// root of the piece's area). NaN: no shape was found, or nothing was solved.
  double constraint_residual = std::numeric_limits<double>::quiet_NaN();

  /// Of Eq. (1) at the end; the weight of a node of mean length is 1; NaN for the first feasible point. Refined: of f +
  /// λᵀc for all pieces that seams which give hold together, over the root of their area, and by h over it; at bounds
  /// only what points inside; NaN else.
  double projected_gradient = std::numeric_limits<double>::quiet_NaN();

  /// Refined: arap_energy, or cloth_energy with a cloth, + angle term, + barriers where triangles are about to turn
  /// over or threads to shear in zigzags. NaN for other methods.
  double objective = std::numeric_limits<double>::quiet_NaN();

  std::map<std::string, double> seconds;  // per stage
};

/// One flat piece: a chart's planar shape and everything measured on it.
struct Piece {
  Positions2 vertices;                     // (p, 2) scene units; NaN without a layout
  Triangles faces;                         // (q, 3) indices into this piece's vertices
  std::vector<int> source_vertex;          // (p,) a vertex on a seam can stand for several piece vertices, one per side
  std::vector<int> source_face;            // (q,) the input face of each face
  std::vector<WireReport> wires;           // one per part of a wire in this piece
  std::vector<BoundaryReport> boundaries;  // one per chain of its outline between junctions
  std::vector<HelperWire> helper_wires;    // the wires that the method added
  Metrics metrics;                         // distortion
  PieceReport report;                      // what the solver did
  std::optional<FlattenError> error;       // which promise is not kept; none: every promise is kept
};

/// All pieces of a flattening and how they fit together.
struct FlattenResult {
  std::vector<Piece> pieces;              // one per region between seams
  CornerUv corner_uv;                     // (m, 3 corners, u and v) in scene units; NaN without a layout
  std::vector<SeamReport> seams;          // one per chain of seam edges between junctions
  std::vector<WireReport> wires;          // whole wires
  std::string method;                     // the method used, or "measure"
  int reused_pieces = 0;                  // taken from the cache instead of being solved again
  std::map<std::string, double> seconds;  // per stage, summed over pieces side by side; and "total"
};

}  // namespace wirewarp
