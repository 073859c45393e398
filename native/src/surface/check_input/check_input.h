// SPDX-License-Identifier: GPL-3.0-or-later
// Checks for faults that make the whole input unusable. cut_into_charts() finds the faults of single charts.
#pragma once

#include "surface/mesh/edge_table.h"
#include "wirewarp/flatten.h"

namespace wirewarp {

/// Coordinates must be below this limit in magnitude, scene units. Otherwise, squared areas would overflow.
constexpr double kCoordinateLimit = 1e60;

/// Throws invalid_option unless every option is in its documented range for an input with num_wires wires.
void check_options(const Options& options, std::size_t num_wires);

/// Throws empty_mesh, vertex_out_of_range or non_finite_coordinates (also if coordinates are too large).
void check_mesh(const FlattenInput& input);

/// Throws loose_faces for a mesh of separate faces, each of which would be a piece.
void check_faces_share_edges(const FlattenInput& input, const EdgeTable& edges);

/// Throws seam_not_an_edge, wire_too_short, wire_not_an_edge, edge_in_two_wires, invalid_tolerance, invalid_ease,
/// ease_without_side, side_in_two_eases or, for a wire's name, invalid_type.
void check_seams_and_wires(const FlattenInput& input, const EdgeTable& edges);

}  // namespace wirewarp
