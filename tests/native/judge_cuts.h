// SPDX-License-Identifier: GPL-3.0-or-later
// Compares the claimed figures of suggested cuts with those of a new run.
#pragma once

#include <set>
#include <vector>

#include "wirewarp/cut_mesh.h"
#include "wirewarp/flatten.h"
#include "wirewarp/propose.h"

namespace wirewarp::test {

/// Returns the strain of the most strained piece. A piece's strain is the value of max(sigma_1, 1/sigma_2) - 1 that 99%
/// of its area does not exceed. Every piece must have a shape.
double most_strain(const FlattenInput& input, const FlattenResult& result);

/// Returns the energy of all pieces over their area.
double energy_of(const FlattenResult& result, bool has_cloth = false);

/// Returns each edge once, with its smaller vertex first.
std::set<VertexPair> undirected(const std::vector<VertexPair>& edges);
std::set<VertexPair> undirected(const VertexPairs& edges);

/// Returns the total length of all seams on the surface.
double length_of_seams(const FlattenInput& input);

/// Returns the model with its mesh cut along these lines, and with a seam along each line.
FlattenInput with_paths(FlattenInput input, const std::vector<SurfacePath>& paths);

/// Returns the position in space of point i of a path.
Eigen::RowVector3d point_of(const FlattenInput& input, const SurfacePath& path, std::size_t i);

struct CutFigures {
  double energy, strain, length;
  int num_pieces;
};

/// Flattens the cut model without a fabric. Expects that every piece has a flat shape, and that the claimed figures are
/// those of this run.
void expect_figures(const FlattenInput& cut, const CutFigures& claimed);

/// Cuts the model along the lines of a suggested dart or set of seams, or along its edges if it has no lines. Expects
/// that the claimed figures are true.
void expect_figures(const FlattenInput& input, const DartProposal& claimed);

}  // namespace wirewarp::test
