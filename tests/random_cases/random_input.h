// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "judged.h"
#include "random_stream.h"
#include "wirewarp/flatten.h"

namespace wirewarp::test {

inline void add_face(FlattenInput& input, int a, int b, int c) {
  input.faces.conservativeResize(input.faces.rows() + 1, 3);
  input.faces.bottomRows(1) << a, b, c;
}

inline int add_vertex(FlattenInput& input, const Eigen::RowVector3d& position) {
  input.vertices.conservativeResize(input.vertices.rows() + 1, 3);
  input.vertices.bottomRows(1) = position;
  return static_cast<int>(input.vertices.rows()) - 1;
}

/// A manifold part of a mesh, with faces counter-clockwise from outside.
struct MeshPart {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<int, 3>> faces;
};

/// Returns a mesh like a scan, with a rough height, up to four holes, and needles of up to 1 : 10,000. Appends a word
/// to the description.
MeshPart rough_sheet(RandomStream& random, std::string& description);

/// Returns a legal mesh of one to three separate parts, of any size and place, with vertices and faces in any order.
/// Appends words about the mesh to the description.
FlattenInput random_mesh(RandomStream& random, std::string& description);

/// Adds random seams, or sometimes no seams. Seams are walks along edges, shortest paths between borders, or small
/// darts, slits and loops.
void add_random_seams(RandomStream& random, FlattenInput& input, std::string& description);

/// Adds random wires of every kind, sometimes many. Wires are walks or shortest paths along edges without a wire. They
/// may be closed, and may run along seams and outlines.
void add_random_wires(RandomStream& random, FlattenInput& input, std::string& description);

/// Lets two parts of a legal mesh touch in one vertex, and may add a wire through this vertex. Returns false, with the
/// input unchanged, if the two random vertices belong to one part.
bool let_parts_touch(RandomStream& random, FlattenInput& input);

/// Adds to legal input of the refined method: a fabric that is stretched when worn, sometimes wires along seams, and
/// sometimes eases of wires and sides. Appends words about the changes to the description.
void add_random_stretch(RandomStream& random, FlattenInput& input, Options& options, std::string& description);

/// Adds one fault to a legal input, and returns the error that must result.
ErrorCode add_random_fault(RandomStream& random, FlattenInput& input, Options& options);

}  // namespace wirewarp::test
