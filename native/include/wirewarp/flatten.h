// SPDX-License-Identifier: GPL-3.0-or-later
// The whole public API: flatten() makes flat pieces, measure() judges any flattening by the same code.
//
// The method is that of Y. Zhang and C. C. L. Wang, "WireWarping++: Robust and Flexible Surface Flattening With Length
// Control", IEEE Transactions on Automation Science and Engineering. "Paper", equations and sections are of it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "wirewarp/options.h"
#include "wirewarp/result.h"

namespace wirewarp {

/// A line that matters: a chain of mesh edges with a length (1 + h) l, |h - ease| <= tolerance. Along a seam or the
/// edge of the surface it says how long that stretch is, on all its sides alike.
struct Wire {
  std::vector<int> vertices;  // (n,) consecutive ones joined by an edge; a closed wire repeats its first vertex
  double tolerance = 0;  // dimensionless; 0 rigid; finite: elastic; infinity: super-elastic, along an outline any h
  std::string name;      // UTF-8, for reports
  double ease = 0;       // dimensionless, how much longer it is to be: finite, above -1
};

/// Throws FlattenError (wire_too_short, invalid_tolerance, invalid_ease) where a wire fits no mesh; invalid_type if its
/// name has a NUL character.
void check_wire(const Wire& wire);

/// One side of a seam, or a stretch of the edge of the surface, that is longer than its 3D length or its mate: (1 +
/// ratio) times what it would be, evenly. Sleeve heads have 0.05, gathers 1.
struct Ease {
  VertexPairs half_edges;  // (k, 2) a, b: the side of the triangle that has b after a
  double ratio = 0;        // dimensionless: finite, above -1
};

/// Throws FlattenError (invalid_ease) where an ease fits no mesh.
void check_ease(const Ease& ease);

/// A triangle mesh, the seams that cut it and the wires on it.
struct FlattenInput {
  Positions3 vertices;  // magnitudes below 1e60
  Triangles faces;
  VertexPairs seams;  // edges along which the surface is cut
  std::vector<Wire> wires;
  std::vector<Ease> eases{};
};

class Cache;

/// Called with the stage ("charts", "start", "shape", "wires", "interior", "lengths", "measure") and the fraction of
/// the run in [0, 1], after so much work at most, be the pieces few and large or thousands. Returning false cancels the
/// pieces that are not flat yet; all pieces in "charts", which comes first, in "measure", which comes last, and where
/// those that are flat take long to measure. Pieces are solved on several cores, but this is called in the thread that
/// called flatten() alone.
using Progress = std::function<bool(const std::string& stage, double fraction)>;

/// Flattens every chart of the input; pieces laid out without overlap, front faces with positive area.
/// Throws FlattenError if the input is not a mesh with seams and wires or an option is out of range; a chart that
/// cannot be flattened carries its FlattenError in its Piece and spares the others. With a cache (wirewarp/cache.h),
/// charts that are as they were in its last run are not solved again. Safe to call from several threads.
FlattenResult flatten(const FlattenInput& input, const Options& options = {}, const Progress& progress = {},
                      Cache* cache = nullptr);

/// The measures and the guarantee of flatten() for a flattening made elsewhere, in scene units. No packing, no scaling:
/// corner_uv is returned as given. A chart with a corner that is not finite and below 1e60 in magnitude has no_layout.
/// Nothing is solved: a million triangles take about a second, and there is no progress to cancel.
FlattenResult measure(const FlattenInput& input, const CornerUv& corner_uv);

}  // namespace wirewarp
