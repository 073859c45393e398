// SPDX-License-Identifier: GPL-3.0-or-later
// The lengths of flat pieces for a fabric that is stretched when worn (Cloth::stretch). Across and along the grain, the
// stretch is c_weft and c_warp. An edge has the length l on the surface, and the angle ψ from the weft in the layout
// without the stretch. It gets the flat length
//
//   L = l √(cos²ψ / (1 + c_weft)² + sin²ψ / (1 + c_warp)²).
//
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

using PerEdge = std::vector<double>;

struct StretchedLengths {
  std::vector<PerEdge> ratios;                     // L / l, per chart; empty for a chart without a layout
  std::vector<std::vector<std::string>> warnings;  // per chart: about seams whose sides would have different lengths
};

/// Returns the stretched lengths and warnings of all charts. solved: upright layouts without the stretch.
StretchedLengths find_stretched_lengths(const Charts& charts, const std::vector<SolvedChart>& solved,
                                        const Cloth& cloth);

}  // namespace wirewarp
