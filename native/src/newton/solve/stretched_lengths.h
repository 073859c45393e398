// SPDX-License-Identifier: GPL-3.0-or-later
// The lengths of flat pieces for a fabric that is stretched when worn (Cloth::stretch). An edge at the angle ψ from the
// weft, in the layout without the stretch, gets the flat length
//
//   L = l √(cos²ψ / (1 + c_weft)² + sin²ψ / (1 + c_warp)²)
//
// l is the length of the edge on the surface, and c_weft and c_warp are the stretch in both directions of the fabric.
// The sides of a seam use the mean of their ratios L / l, so that the sides stay equally long. An edge with an ease
// keeps its eased length.
#pragma once

#include <string>
#include <vector>

#include "newton/solved_chart.h"
#include "surface/charts/chart.h"
#include "wirewarp/cloth.h"

namespace wirewarp {

bool is_stretched(const Options& options);

/// One number per edge of a chart.
using PerEdge = std::vector<double>;

struct StretchedLengths {
  std::vector<PerEdge> ratios;                     // L / l, per chart; empty for a chart without a layout
  std::vector<std::vector<std::string>> warnings;  // per chart: seams whose sides would shrink differently
};

/// Returns the stretched lengths and warnings of all charts. solved: upright layouts without the stretch.
StretchedLengths find_stretched_lengths(const Charts& charts, const std::vector<SolvedChart>& solved,
                                        const Cloth& cloth);

}  // namespace wirewarp
