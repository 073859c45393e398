// SPDX-License-Identifier: GPL-3.0-or-later
// A key that two charts share if and only if they have the same solution. It has all bytes and is not a digest, so that
// collisions are impossible.
#pragma once

#include <string>

#include "surface/charts/chart.h"

namespace wirewarp {

/// All that the solutions of sound charts that are solved together depend on, in their own numbering, so that a change
/// elsewhere in the input does not alter it: meshes, outlines, slits, wire parts, which of them share a length, and the
/// options of the solver, bit for bit. Only the words of an error may differ, see name_key().
std::string solution_key(const std::vector<const Chart*>& group, const Options& options);

/// How the input numbers and names what is in the charts: vertices, faces and wires.
std::string name_key(const std::vector<const Chart*>& group, const std::vector<Wire>& wires);

}  // namespace wirewarp
