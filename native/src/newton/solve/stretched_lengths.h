// SPDX-License-Identifier: GPL-3.0-or-later
// The lengths of flat pieces for a cloth that is stretched when it is worn (Cloth::stretch). Without the stretch every
// chart has a layout, in which each edge has a direction: with ψ its angle from the weft, its flat length shrinks to
//
//   L = l √(cos²ψ / (1 + c_weft)² + sin²ψ / (1 + c_warp)²),
//
// On a seam, the mean of its sides' ratios is used, so that they stay equal. An edge with an ease keeps its eased
// length.
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
  std::vector<std::vector<std::string>> warnings;  // per chart: sides of a seam would shrink by different shares
};

/// solved: upright layouts without the stretch.
StretchedLengths find_stretched_lengths(const Charts& charts, const std::vector<SolvedChart>& solved,
                                        const Cloth& cloth);

}  // namespace wirewarp
