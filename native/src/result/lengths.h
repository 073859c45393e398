// SPDX-License-Identifier: GPL-3.0-or-later
// The length report: wires, stretches of outline and seams, 3D against 2D. Lengths in scene units.
#pragma once

#include "surface/charts/chart.h"

namespace wirewarp {

/// One report per wire part of the chart, in the order of chart.wire_parts.
/// wires: the input's, for the names. variation: h, one per part.
std::vector<WireReport> measure_wire_parts(const Chart& chart, const std::vector<Wire>& wires, const Positions2& uv,
                                           const std::vector<double>& variation);

/// One report per boundary chain of the chart, in the order of chart.boundary_chains. variation: h, one per wire part.
std::vector<BoundaryReport> measure_boundaries(const Chart& chart, const Positions2& uv,
                                               const std::vector<double>& variation);

/// One report per seam. pieces[i] is the flat piece of charts.charts[i] with its wires and boundaries measured; a piece
/// without layout has none, and its sides are NaN.
std::vector<SeamReport> measure_seams(const FlattenInput& input, const Charts& charts,
                                      const std::vector<Piece>& pieces);

/// One report per wire of the input, over all its parts in all pieces. Every edge counts once: where the wire runs
/// along a seam, with the side in the first piece. A wire that is all seam or boundary is of kind boundary. length_2d,
/// variation and max_edge_error are NaN where a part of the wire has no layout. pieces as above, with their wires
/// measured.
std::vector<WireReport> measure_whole_wires(const FlattenInput& input, const Charts& charts,
                                            const std::vector<Piece>& pieces);

/// The length variation h, one per wire part, that a layout made elsewhere seems to follow: the ease of rigid parts; of
/// the others the variation of the whole part's length, of all sides in the chart, held within its tolerance.
std::vector<double> fit_variation(const Chart& chart, const Positions2& uv);

}  // namespace wirewarp
