// SPDX-License-Identifier: GPL-3.0-or-later
// The stage of elastic seams: a coupled group finds the common lengths of its elastic seams within their tolerances
// (group_solver.h). It starts from charts that were solved by themselves with these seams fixed at h = ease.
#pragma once

#include <vector>

#include "newton/solve/group_solver.h"

namespace wirewarp {

/// Frees the elastic seams of a group. Without common lengths, each chart is solved completely at h = ease. If that
/// fails too, the chart keeps its shape, and its report says so. A chart without a shape at h = ease gets the error
/// that it has there.
void free_elastic_seams(const std::vector<GroupMember>& group, const Run& run, const StopToken& stop);

}  // namespace wirewarp
