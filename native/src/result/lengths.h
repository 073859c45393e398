// SPDX-License-Identifier: GPL-3.0-or-later
// The length report: wires, sections of outline and seams, in 3D and 2D. Lengths are in scene units.
#pragma once

#include "surface/charts/chart.h"

namespace wirewarp {

/// Returns one report per wire part of the chart, in the order of chart.wire_parts. wires: the input's wires, for their
/// names. variation: h, one per part.
std::vector<WireReport> measure_wire_parts(const Chart& chart, const std::vector<Wire>& wires, const Positions2& uv,
                                           const std::vector<double>& variation);

/// Returns one report per boundary chain of the chart, in the order of chart.boundary_chains. variation: h, one per
/// wire part.
std::vector<BoundaryReport> measure_boundaries(const Chart& chart, const Positions2& uv,
                                               const std::vector<double>& variation);

/// Returns one report per seam. pieces[i] is the flat piece of charts.charts[i], with measured wires and boundaries.
/// The lengths of sides in a piece without a layout are NaN.
std::vector<SeamReport> measure_seams(const FlattenInput& input, const Charts& charts,
                                      const std::vector<Piece>& pieces);

/// Returns one report per wire of the input, over all its parts in all pieces. Every edge counts once; an edge along a
/// seam counts with its side in the first piece. A wire that runs only along seams or boundaries has the kind boundary.
/// length_2d, variation and max_edge_error are NaN if a part of the wire has no layout. pieces: as for measure_seams().
std::vector<WireReport> measure_whole_wires(const FlattenInput& input, const Charts& charts,
                                            const std::vector<Piece>& pieces);

/// Returns the length variation h, one per wire part, that fits a layout from any program. For rigid parts, h is the
/// ease. For other parts, it is the relative change of the total length over all sides in the chart, clamped to the
/// tolerance around the ease.
std::vector<double> fit_variation(const Chart& chart, const Positions2& uv);

}  // namespace wirewarp
