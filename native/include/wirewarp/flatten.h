// SPDX-License-Identifier: GPL-3.0-or-later
// The main header. flatten() makes flat pieces. measure() measures and checks a flattening from any program by the same
// rules. The other headers in this folder suggest cuts, make them in the mesh and straighten their lines.
//
// The library extends the method of Y. Zhang and C. C. L. Wang, "WireWarping++: Robust and Flexible Surface Flattening
// With Length Control", IEEE Transactions on Automation Science and Engineering. In all comments, "paper" and the
// numbers of equations and sections refer to this article.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "wirewarp/options.h"
#include "wirewarp/result.h"

namespace wirewarp {

/// A measuring line along mesh edges, with the length l on the surface. Its flat length is (1 + h) l with
/// |h - ease| <= tolerance. Along a seam or outline, it sets the length of its section, equally on all sides.
struct Wire {
  std::vector<int> vertices;  // (n,) each joined to the next by an edge; a closed wire repeats its first vertex
  double tolerance = 0;       // dimensionless; 0: rigid; finite: elastic; infinity: free, with any length
  std::string name;           // UTF-8, for reports
  double ease = 0;            // dimensionless: intended relative change of length; finite, above -1
};

/// Throws FlattenError (wire_too_short, invalid_tolerance, invalid_ease) if the wire cannot be valid on any mesh, and
/// invalid_type if its name has a NUL character.
void check_wire(const Wire& wire);

/// One side of a seam, or a section of outline, that becomes longer by the factor 1 + ratio, evenly. Typical ratios are
/// 0.05 for a sleeve head and 1 for gathers.
struct Ease {
  VertexPairs half_edges;  // (k, 2) vertices a and b of each edge, on the side of the triangle that has b after a
  double ratio = 0;        // dimensionless: finite, above -1
};

/// Throws FlattenError (invalid_ease) if the ease cannot be valid on any mesh.
void check_ease(const Ease& ease);

/// A triangle mesh, the seams that cut it and the wires on it.
struct FlattenInput {
  Positions3 vertices;  // coordinates with magnitudes below 1e60
  Triangles faces;
  VertexPairs seams;  // edges along which the surface is cut
  std::vector<Wire> wires;
  std::vector<Ease> eases{};
};

class Cache;

/// Called at regular intervals of work, in the thread that called flatten(). Returning false cancels pieces.
///
/// - stage: "charts", "start", "shape", "wires", "interior", "lengths" or "measure"; "cuts" in a search for cuts
/// - fraction: share of the run, in [0, 1]
/// - false in the stage "charts" or "measure" cancels all pieces
/// - false in another stage cancels the pieces that are not flat yet
using Progress = std::function<bool(const std::string& stage, double fraction)>;

/// Flattens every chart of the input and packs the pieces without overlap. Front faces have positive area.
///
/// - Throws FlattenError if an option is out of range, or if the input is not a mesh with seams and wires.
/// - If a chart cannot be flattened, its Piece contains the FlattenError. The other pieces are not affected.
/// - With a cache, charts that have not changed since its last run are not solved again.
/// - Several threads may call this function at the same time.
FlattenResult flatten(const FlattenInput& input, const Options& options = {}, const Progress& progress = {},
                      Cache* cache = nullptr);

/// Measures and checks a flattening that was made elsewhere, by the same rules as flatten().
///
/// - corner_uv: in scene units. The result contains it unchanged, neither packed nor scaled.
/// - Error no_layout: a corner of the chart is not finite, or not below 1e60 in magnitude.
/// - Error uv_discontinuous: a vertex of the chart has several flat positions.
/// - Nothing is solved: a million triangles take about a second.
FlattenResult measure(const FlattenInput& input, const CornerUv& corner_uv);

}  // namespace wirewarp
