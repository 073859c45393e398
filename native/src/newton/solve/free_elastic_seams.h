// SPDX-License-Identifier: GPL-3.0-or-later
// The stage of elastic seams: a coupled group finds the common lengths of its elastic seams within their tolerances
// (group_solver.h). It starts from charts that were solved individually with these seams fixed at h = ease.
#pragma once

#include <vector>

#include "newton/solve/group_solver.h"

namespace wirewarp {

/// Frees the elastic seams of a group. If no common lengths are found, solves each chart completely at h = ease. If
/// that fails too, the chart keeps its shape, and its report says so. A chart without a shape at h = ease gets the
/// error of that search.
void free_elastic_seams(const std::vector<GroupMember>& group, const Run& run, const StopToken& stop);

}  // namespace wirewarp
