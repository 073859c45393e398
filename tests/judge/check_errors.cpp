// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>

#include "checks.h"
#include "judge.h"

namespace wirewarp::test {
namespace {

struct Topology {
  int num_loops = 0;
  int num_handles = 0;
  double longest_loop = 0;  // length on the surface
  double area = 0;          // area on the surface
};

Topology topology_of(const Judged& judged, const Piece& piece) {
  Topology topology;
  const auto position = [&](int v) { return judged.position(piece.source_vertex[v]); };
  for (const auto& corners : piece.faces.rowwise()) {
    const Eigen::Vector3d a = position(corners[0]);
    topology.area += (position(corners[1]) - a).cross(position(corners[2]) - a).norm() / 2;
  }
  std::map<int, int> next;  // next vertex along the outline
  for (const auto& [a, b] : judged.outline_of(piece)) next[a] = b;
  const auto num_edges = (3 * static_cast<int>(piece.faces.rows()) + static_cast<int>(next.size())) / 2;
  while (!next.empty()) {
    ++topology.num_loops;
    double length = 0;
    for (auto edge = next.begin(); edge != next.end();) {
      length += (position(edge->first) - position(edge->second)).norm();
      const int reached = edge->second;
      next.erase(edge);
      edge = next.find(reached);
    }
    topology.longest_loop = std::max(topology.longest_loop, length);
  }
  const int characteristic =
      static_cast<int>(piece.source_vertex.size()) - num_edges + static_cast<int>(piece.faces.rows());
  topology.num_handles = (2 - topology.num_loops - characteristic) / 2;
  return topology;
}

void check_named_elements(Judged& judged, int number) {
  const Piece& piece = judged.result.pieces[number];
  const ErrorElements& named = piece.error->elements;
  const std::set<int> vertices(piece.source_vertex.begin(), piece.source_vertex.end());
  bool all_here = std::all_of(named.vertices.begin(), named.vertices.end(), [&](int v) { return vertices.count(v); });
  for (const int face : named.faces) all_here = all_here && judged.piece_of(face) == number;
  for (const VertexPair& pair : named.edges) {
    all_here = all_here && !judged.sides_in(edge_of(pair[0], pair[1]), number).empty();
  }
  if (!all_here) judged.say("an error names elements of another piece");
  for (const VertexPair& pair : named.proposed_seams) {
    const Edge edge = edge_of(pair[0], pair[1]);
    if (judged.sides_in(edge, number).size() != 2 || judged.is_outline(edge)) {
      judged.say("proposed seam " + name(edge) + " does not cut the piece");
    }
  }
}

/// Checks that tolerances are proposed for wires inside the piece, and are larger than the wires' own tolerances.
void check_tolerances(Judged& judged, int number) {
  for (const ProposedTolerance& proposed : judged.result.pieces[number].error->elements.proposed_tolerances) {
    const Wire& wire = judged.input.wires[proposed.wire];
    const std::vector<Edge> edges = edges_of(wire);
    const bool is_inside = std::any_of(edges.begin(), edges.end(), [&](const Edge& edge) {
      return !judged.sides_in(edge, number).empty() && !judged.is_outline(edge);
    });
    if (!is_inside) judged.say("a tolerance is proposed for " + wire.name + ", which is not in the piece");
    const double has = judged.options.method == Method::wirewarping ? 0 : wire.tolerance;
    if (!(proposed.tolerance > has))
      judged.say("the tolerance proposed for " + wire.name + " is not larger than its own");
  }
}

void check_flips(Judged& judged, const Piece& piece) {
  for (const int face : piece.error->elements.faces) {
    if (doubled_area(judged.triangle(face)) > 0) judged.say("face " + std::to_string(face) + " is reported as flipped");
  }
}

/// Returns whether a piece's target lengths may differ from its lengths on the surface, by an ease, a tolerance or the
/// stretch. Possibly neither seams nor tolerances fix the error of such a piece.
bool has_other_target_lengths(const Judged& judged, int number) {
  const bool is_of_stretch = judged.unstretched && !judged.unstretched->pieces[number].error;
  return is_of_stretch || has_other_outline(judged, judged.result.pieces[number]);
}

}  // namespace

bool is_of_mesh(ErrorCode code) {
  switch (code) {
    case ErrorCode::repeated_vertex_in_face:
    case ErrorCode::repeated_face:
    case ErrorCode::zero_area_face:
    case ErrorCode::non_manifold_edge:
    case ErrorCode::non_manifold_vertex:
    case ErrorCode::inconsistent_orientation:
      return true;
    default:
      return false;
  }
}

void check_error(Judged& judged, int number) {
  const Piece& piece = judged.result.pieces[number];
  const FlattenError& error = *piece.error;
  for (std::string& fault : faults_of_error(error, judged.input)) judged.say(std::move(fault));
  if (error.has_layout != judged.has_layout(piece)) judged.say("has_layout is wrong");
  // The checks below need a valid mesh, and a run that was not canceled.
  if (is_of_mesh(error.code) || error.code == ErrorCode::cancelled) return;

  check_named_elements(judged, number);
  const Topology topology = topology_of(judged, piece);
  const bool is_closed = error.code == ErrorCode::closed_chart, has_handles = error.code == ErrorCode::handles;
  if (is_closed != (topology.num_loops == 0)) judged.say("an error reports the wrong topology: closed or open");
  if (has_handles != (topology.num_loops > 0 && topology.num_handles > 0))
    judged.say("an error reports the wrong number of handles");
  const bool has_seams = !error.elements.proposed_seams.empty();
  const bool has_tolerances = !error.elements.proposed_tolerances.empty();
  if (has_tolerances && error.code != ErrorCode::infeasible_lengths) judged.say("tolerances cannot fix this error");
  check_tolerances(judged, number);
  switch (error.code) {
    case ErrorCode::closed_chart:
    case ErrorCode::handles:
      if (!has_seams) judged.say("no seam is proposed");
      break;
    case ErrorCode::boundary_too_short: {
      // Area of a circle with the length of the longest loop, divided by the piece's area. If this ratio is above the
      // minimum, the outline is not too short (see native/src/surface/charts/isoperimetric.cpp).
      const double share = topology.longest_loop * topology.longest_loop / (4 * 3.141592653589793 * topology.area);
      if (share > (topology.num_loops > 1 ? 0.45 : 0.25) * (1 + 1e-9)) judged.say("the outline is not too short");
      if (!has_seams) judged.say("no seam is proposed");
      break;
    }
    case ErrorCode::infeasible_lengths:
      if (has_seams && has_tolerances) judged.say("both seams and tolerances are proposed");
      if (judged.options.method == Method::refined && !has_other_target_lengths(judged, number) && !has_seams &&
          !has_tolerances) {
        judged.say("nothing is proposed");
      }
      break;
    case ErrorCode::flipped_faces:
      check_flips(judged, piece);
      [[fallthrough]];
    case ErrorCode::overlapping_faces:
      if (judged.options.method == Method::refined && !has_seams && !has_other_outline(judged, piece)) {
        judged.say("no seam is proposed");
      }
      break;
    default:
      break;
  }
}

}  // namespace wirewarp::test
