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

/// Returns one report per wire of the input, over its parts in all pieces. Each edge counts once, with its side in the
/// first piece that has the edge. Flat figures are NaN if a part has no layout.
std::vector<WireReport> measure_whole_wires(const FlattenInput& input, const Charts& charts,
                                            const std::vector<Piece>& pieces);

/// Fits the length variation h of each wire part to a layout from any program. For rigid parts, h is their ease. For
/// other parts, h is the change of their total length, clamped to the tolerance.
std::vector<double> fit_variation(const Chart& chart, const Positions2& uv);

}  // namespace wirewarp
