// SPDX-License-Identifier: GPL-3.0-or-later
// What tells whether a chart is the same as one that was solved before. Whole bytes and no digest: equal keys are equal
// charts, never a collision.
#pragma once

#include <string>

#include "charts/chart.h"

namespace wirewarp {

/// All that the solution of a sound chart depends on, in the chart's own numbering, so that a change elsewhere in the
/// input does not alter it: mesh, outline, slits, wire parts and the options of the solver, bit for bit. Only the words
/// of an error may differ, see name_key().
std::string solution_key(const Chart& chart, const Options& options);

/// How the input numbers and names what is in the chart: vertices, faces and wires.
std::string name_key(const Chart& chart, const std::vector<Wire>& wires);

}  // namespace wirewarp
